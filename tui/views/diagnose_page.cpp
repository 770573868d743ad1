// What the keys of the Diagnose screen do.
#include "tui/screen/number.hpp"
#include "tui/views/diagnose_details.hpp"
#include "tui/views/diagnose_view.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/workbench/diagnosed_effects.hpp"
#include "updating/localisation/signature.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

using updating::Candidate;
using updating::EffectRef;

/// Of the model as it is, as far as it was looked at, or before; none before
/// there is any.
const updating::Diagnosis* found(const Snapshot& known) {
  if (known.diagnosis) return known.diagnosis.get();
  return known.preliminary ? known.preliminary.get()
                           : known.last_diagnosis.get();
}

Standing standing_of(const Snapshot& known) {
  if (known.diagnosis) return Standing::Final;
  return known.preliminary ? Standing::Preliminary : Standing::Outdated;
}

/// @pre there is one
const updating::Diagnosis& shown(const Snapshot& known) {
  return *found(known);
}

void add_verdict(const updating::Diagnosis& d, Command& command) {
  command.effects = verdict_of(d);
  if (command.effects.empty()) {
    command.message = "the verdict adds nothing to the model";
  } else {
    command.kind = Command::Kind::Add;
  }
}

/// A word of caution where one of these can't be told from the candidate.
std::string look_alike_among(const std::vector<EffectRef>& tagged,
                             const Candidate& c) {
  for (const EffectRef& other : c.indistinguishable_from) {
    if (std::ranges::find(tagged, other) == tagged.end()) continue;
    return fmt::format("{} {} looks the same: neither size will be sure",
                       other.effect,
                       place(other.where));
  }
  return {};
}

/// Pages scroll down or up, as far as there are lines.
void scroll(std::optional<int>& first, Key key, std::size_t lines) {
  constexpr int page = 10;
  const int last = std::max(static_cast<int>(lines) - page, 0);
  const int step = key == keys::page_down ? page : -page;
  first = std::clamp(first.value_or(0) + step, 0, last);
}

}  // namespace

bool DiagnosePage::can_wait_for(const Need& need, const Snapshot& known) const {
  const bool made_anew = need.stage == Stage::Comparison ||
                         need.stage == Stage::Ladder ||
                         need.stage == Stage::Diagnosis;
  return made_anew && found(known) != nullptr;
}

std::vector<Need> DiagnosePage::welcome(const Snapshot& known) const {
  std::vector<Need> needs{{Stage::Model}};
  const updating::Diagnosis& d = *known.diagnosis;
  if (state_.firmness) needs.push_back({Stage::Robustness});
  if (d.candidates.empty() || state_.list.nowhere) return needs;
  const Table table = candidate_table(d, {}, 80, true);
  const std::size_t at = settled(table, state_.list);
  const Candidate& c = d.candidates[at];
  if (const auto grid = signature_grid(*known.bundle, c)) {
    needs.push_back({Stage::Signature, *grid});
  }
  const bool curves =
      state_.evidence || !has_signature(*known.bundle, known.signatures, c);
  if (curves && c.effect != updating::nonlinearity) {
    needs.push_back({Stage::CandidateEvidence, static_cast<int>(at)});
  }
  if (state_.map) needs.push_back({Stage::LocalisationMap});
  return needs;
}

Screen DiagnosePage::draw(const Snapshot& known, const Canvas& canvas) const {
  DiagnoseInput input{*known.bundle,
                      shown(known),
                      known.signatures,
                      known.wire.get(),
                      known.localisation_map.get(),
                      standing_of(known),
                      known.deck.get(),
                      known.frfs.get()};
  if (state_.list.nowhere && chosen_) input.missing = &*chosen_;
  const Table table = candidate_table(input.diagnosis, {}, 80, true);
  const auto found = known.candidate_evidence.find(
      static_cast<int>(settled(table, state_.list)));
  if (found != known.candidate_evidence.end()) {
    input.evidence = found->second.get();
  }
  return diagnose_view(input, state_, canvas);
}

std::optional<EffectRef> DiagnosePage::stood_on(const Snapshot& known) {
  const updating::Diagnosis* d = found(known);
  if (state_.list.nowhere || d == nullptr || d->candidates.empty()) {
    return chosen_;
  }
  const std::size_t at =
      settled(candidate_table(*d, {}, 80, true), state_.list);
  const EffectRef here = ref_of(d->candidates[at]);
  if (at > 0 || chosen_ == here) return chosen_ = here;
  chosen_.reset();
  // Nobody chose what happened to lead before there was a verdict.
  if (standing_of(known) == Standing::Preliminary) return std::nullopt;
  return here;
}

void DiagnosePage::follow(const Snapshot& before, const Snapshot& now) {
  const updating::Diagnosis* fresh = found(now);
  if (fresh == nullptr || found(before) == fresh) return;
  const std::optional<EffectRef> stood = stood_on(before);
  state_.list.selected = 0;
  state_.list.nowhere = false;
  if (!stood) return;
  const auto at = std::ranges::find(fresh->candidates, *stood, ref_of);
  if (at != fresh->candidates.end()) {
    state_.list.selected =
        static_cast<std::size_t>(at - fresh->candidates.begin());
    return;
  }
  const Snapshot::Effects on = now.effects_on();
  if (std::ranges::find(on, *stood) != on.end()) chosen_.reset();
  state_.list.nowhere = chosen_.has_value() && !fresh->candidates.empty();
}

bool DiagnosePage::leave_view() {
  if (std::exchange(state_.details, {})) return true;
  if (std::exchange(state_.firmness, {})) return true;
  if (std::exchange(state_.map, false)) return true;
  if (std::exchange(state_.evidence, false)) return true;
  return !std::exchange(state_.tagged, {}).empty();
}

void DiagnosePage::press_tag(const updating::Diagnosis& d,
                             const Table& table,
                             Command& command) {
  if (d.candidates.empty()) return;
  const Candidate& c = d.candidates[settled(table, state_.list)];
  const EffectRef ref = ref_of(c);
  if (std::erase(state_.tagged, ref) == 0) {
    command.message = look_alike_among(tagged_of(d, state_.tagged), c);
    state_.tagged.push_back(ref);
  }
  static_cast<void>(list_key(state_.list, table, keys::down));
}

void DiagnosePage::add_chosen(const updating::Diagnosis& d,
                              const Table& table,
                              Command& command) const {
  command.effects = tagged_of(d, state_.tagged);
  if (command.effects.empty()) {
    if (d.candidates.empty()) return;
    const Candidate& c = d.candidates[settled(table, state_.list)];
    command.effects = {ref_of(c)};
  }
  command.kind = Command::Kind::Add;
}

bool DiagnosePage::press_firmness(const updating::Diagnosis& d, Key key) {
  if (key == U'R') {
    state_.details = {};
    state_.firmness = state_.firmness ? std::nullopt : std::optional<int>(0);
    return true;
  }
  const bool page = key == keys::page_down || key == keys::page_up;
  if (!state_.firmness || !page) return false;
  scroll(state_.firmness, key, firmness_lines(d, 78).size());
  return true;
}

bool DiagnosePage::acts_on_nothing(const updating::Diagnosis& d,
                                   Key key) const {
  if (!state_.list.nowhere || !chosen_) return false;
  if (key == U't' || key == U' ' || key == U'i') return true;
  return (key == U'a' || key == keys::enter) &&
         tagged_of(d, state_.tagged).empty();
}

/// All other keys do what they always do.
bool DiagnosePage::press_details(const updating::Diagnosis& d,
                                 const Table& table,
                                 Key key) {
  if (d.candidates.empty()) return false;
  if (key == U'i') {
    state_.firmness = {};
    state_.details = state_.details ? std::nullopt : std::optional<int>(0);
    return true;
  }
  const bool page = key == keys::page_down || key == keys::page_up;
  if (!state_.details || !page) return false;
  const Candidate& chosen = d.candidates[settled(table, state_.list)];
  scroll(state_.details, key, details_of(d, chosen, 78).size());
  return true;
}

bool DiagnosePage::press(const Snapshot& known, Key key, Command& command) {
  const updating::Diagnosis& d = shown(known);
  const Table table = candidate_table(d, {}, 80, true);
  if (none_shown(table, state_.list) && is_row_key(key)) {
    command.message = nothing_matches;
    return true;
  }
  if (acts_on_nothing(d, key)) {
    command.message = missing_words(*chosen_, standing_of(known));
    return true;
  }
  const Standing standing = standing_of(known);
  if (standing == Standing::Preliminary && (key == U'A' || key == U'R')) {
    command.message = "no verdict yet: a adds the one that is chosen";
    command.until_done = true;
    return true;
  }
  if (press_firmness(d, key) || press_details(d, table, key)) return true;
  const bool whole = key == U'A';
  if (key == U'a' || key == keys::enter || whole) {
    if (standing == Standing::Outdated) {
      command.message =
          "these were found before the last change: wait for what "
          "is found now";
      command.until_done = true;
      return true;
    }
    whole ? add_verdict(d, command) : add_chosen(d, table, command);
    return true;
  }
  if (key == U't' || key == U' ') {
    press_tag(d, table, command);
    return true;
  }
  if (key == U'T') {
    untag();
    return true;
  }
  if (key == keys::tab || key == U'm') {
    state_.map = !state_.map;
    return true;
  }
  if (list_key(state_.list, table, key)) {
    if (!d.candidates.empty()) {
      chosen_ = ref_of(d.candidates[settled(table, state_.list)]);
    }
    return true;
  }
  if (sort_key(state_.list, table, key, command.message)) return true;
  return press_plot(known, key, command);
}

bool DiagnosePage::press_plot(const Snapshot& known,
                              Key key,
                              Command& command) {
  if (key == U'f') {
    state_.all_laws = !state_.all_laws;
    return true;
  }
  if (key == U'e' && !has_two_plots(known)) {
    command.message = "of this there are only FRFs with and without it";
    return true;
  }
  if (key == U'e') {
    state_.evidence = !state_.evidence;
    return true;
  }
  if (pose_key(state_.pose, key)) return true;
  for (const auto& [node, signature] : known.signatures) {
    const Eigen::VectorXd& f = signature->frequency_hz;
    if (f.size() > 1 && !state_.evidence) {
      return range_key(state_.range, key, f[0], f[f.size() - 1]);
    }
  }
  const FrequencySpan span = frequency_span(*known.frfs);
  return range_key(
      state_.range, key, span.lo, span.hi, line_spacing(*known.frfs));
}

bool DiagnosePage::has_two_plots(const Snapshot& known) const {
  const updating::Diagnosis* d = found(known);
  if (d == nullptr || d->candidates.empty()) return false;
  const Table table = candidate_table(*d, {}, 80, true);
  return has_signature(*known.bundle,
                       known.signatures,
                       d->candidates[settled(table, state_.list)]);
}

std::vector<KeyHelp> DiagnosePage::keys(const Snapshot& known) const {
  std::vector<KeyHelp> keys{
      {"j k", "candidate"},
      {"a", state_.tagged.empty() ? "add it" : "add tagged"},
      {"A", "add verdict"},
      {"t", "tag"},
      {"i", "notes"},
      {"m", state_.map ? "place" : "map"},
      {"s", "sort"},
      {"e", state_.evidence ? "signature" : "with/without"},
      {"f", "all laws"},
      {"u", "undo"},
      {"^R", "redo"},
      {"h l", "cursor"},
      {"< > ( )", "turn"},
      {"+ -", "zoom"},
      {"[ ]", "pan"},
      {"T", "tags off"},
      {"R", "how firm"},
      {"/", "filter"}};
  if (!has_two_plots(known)) {
    std::erase_if(keys, [](const KeyHelp& k) { return k.key == "e"; });
  }
  return keys;
}

std::string DiagnosePage::help() const {
  return "Physical effects that may be missing from the model, most probable "
         "first: where, how large (± one standard deviation), the error left, "
         "and, for the best, that on data left out of the fit. Numbered ones "
         "make up the verdict together: each is as probable as it says given "
         "the others, the error is that of all. Yellow ones are "
         "indistinguishable from others with these points. Of an effect at one "
         "grid the plot is the missing dynamic "
         "stiffness there: a mass falls with the square of frequency, a "
         "spring is constant, a dashpot is imaginary and rises, an absorber "
         "has a resonance. The dashed curve is the law that fits best, f shows "
         "all. Of all others, and with e, it is the FRF where the effect "
         "shows most, of the model with and without it. m maps what each grid "
         "alone explains, R tells how firm the "
         "verdict is. a adds the candidate, or all tagged (*) at once, A all "
         "that the verdict is made of.";
}

}  // namespace tapfit::tui

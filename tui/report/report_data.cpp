#include "tui/report/report_data.hpp"

#include "updating/effects/effect_ref.hpp"
#include "updating/session/add_diagnosed.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace tapfit::tui {
namespace {

using updating::Session;

/// The grid of the first effect that sits at one; 0 where none does.
int node_of(const std::vector<updating::Rung>& ladder) {
  for (const updating::Rung& rung : ladder) {
    if (rung.where.node != 0) return rung.where.node;
  }
  return 0;
}

bool any_on(const Session& session) {
  const auto effects = session.effects();
  return std::ranges::any_of(effects, &updating::AddedEffect::on);
}

/// Of the base model in a session of its own: what was done in the other one
/// can then be undone as before.
std::optional<updating::Signature> base_signature(
    const Session& session,
    const std::filesystem::path& bundle,
    int node,
    const Progress& progress) {
  if (node == 0) return std::nullopt;
  Session base(bundle, acquisition::Unreadable::LeftOut);
  updating::SavedSession measured;
  measured.overruled = session.overruled();
  measured.modes = session.mode_choices();
  base.take_up(measured);
  return base.signature(node, progress);
}

void work_through(Session& session,
                  ModelResults& results,
                  const Progress& progress) {
  const int node = node_of(session.diagnosis(progress).ladder);
  if (node != 0) results.signature = session.signature(node, progress);
  results.diagnosis = updating::add_diagnosed(session, progress);
}

ModelResults model_results(Session& session,
                           const std::filesystem::path& bundle,
                           const Progress& progress) {
  ModelResults results;
  results.deck = session.deck(progress);
  const bool by_hand = !session.effects().empty();
  if (by_hand) {
    results.diagnosis = session.known_diagnosis(0, progress);
  } else {
    work_through(session, results, progress);
  }
  results.before = session.base_comparison(progress);
  results.after = session.comparison(progress);
  results.ladder = session.ladder(progress);
  results.parameters = session.model_parameters(progress);
  for (const updating::Rung& rung : results.ladder) {
    if (rung.added == updating::base_rung) continue;
    results.evidence.push_back(
        session.evidence({rung.added, rung.where}, {}, progress));
  }
  if (by_hand && any_on(session)) {
    results.signature =
        base_signature(session, bundle, node_of(results.ladder), progress);
    const auto effects = session.effects();
    results.rest =
        session.known_diagnosis(static_cast<std::size_t>(std::ranges::count(
                                    effects, true, &updating::AddedEffect::on)),
                                progress);
  }
  return results;
}

void take(std::vector<std::string>& into,
          const std::vector<std::string>& more) {
  for (const std::string& text : more) {
    if (std::ranges::find(into, text) == into.end()) into.push_back(text);
  }
}

std::vector<std::string> all_warnings(const ReportData& data) {
  std::vector<std::string> found = data.bundle.warnings;
  // What no computation uses is a fact for the reader, and stands in front.
  std::erase_if(found, [](const std::string& warning) {
    return warning.ends_with(": unknown field, not used");
  });
  if (data.model) take(found, data.model->deck.warnings);
  if (data.hits) {
    for (const Finding& finding : data.hits->findings) {
      found.push_back(in_full(finding));
    }
  }
  take(found, data.modes.warnings);
  if (data.model && data.model->diagnosis) {
    take(found, data.model->diagnosis->warnings);
  }
  if (data.model && data.model->rest) take(found, data.model->rest->warnings);
  return found;
}

}  // namespace

std::string today() {
  std::time_t now = std::time(nullptr);
  if (const char* fixed = std::getenv("SOURCE_DATE_EPOCH")) {
    now = static_cast<std::time_t>(std::strtoll(fixed, nullptr, 10));
  }
  return fmt::format("{:%Y-%m-%d}", fmt::localtime(now));
}

ReportData report_data(Session& session,
                       const std::filesystem::path& bundle,
                       const Progress& progress) {
  ReportData data;
  data.path = bundle;
  data.date = today();
  data.bundle = session.bundle();
  data.notes = acquisition::read_test_notes(bundle);
  if (data.bundle.frfs || data.bundle.modes) {
    // Those that ready FRFs came from are no part of the sheet.
    data.bundle.runs.clear();
    data.bundle.channels.clear();
  } else {
    data.hits = session.hits(progress);
  }
  data.overruled = session.overruled();
  data.frfs = session.frfs(progress);
  data.modes = session.modes(progress);
  if (session.has_model()) {
    data.model = model_results(session, bundle, progress);
  }
  data.warnings = all_warnings(data);
  for (const acquisition::LeftOut& run : session.left_out()) {
    data.warnings.push_back(statement(run));
  }
  return data;
}

}  // namespace tapfit::tui

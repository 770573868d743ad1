#include "updating/catalogue/effect_place.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/place_text.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/effects/prestress.hpp"
#include "updating/places/held_support.hpp"
#include "updating/places/near_places.hpp"
#include "updating/set_up/sheet_place.hpp"
#include "updating/set_up/sheet_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace tapfit::updating {

namespace {

// Whose place is told by names, which may be numbers too.
bool sits_on_channels(const effects::Effect& effect) {
  return effect.sits() == effects::Sits::OnChannels;
}

// Throws where a place is not the one grid that an effect sits at.
void check_grid(const effects::Effect& effect,
                const std::string& place,
                const std::string& text) {
  const std::vector<std::string> parts = parts_of(place);
  const bool one_grid = parts.size() == 1 && is_grid(parts[0]);
  // What follows a grid is taken for a form.
  const bool other =
      parts.size() > 1 && is_grid(parts[0]) && !is_grid(parts[1]);
  if (!effect.sits_at_grid() || place.empty() || one_grid || other) return;
  throw InputError(is_grid(parts[0])
                       ? fmt::format("{} sits at one grid", effect.name())
                       : fmt::format("\"{}\" is no grid", parts[0]),
                   fmt::format("effect \"{}\"", text),
                   fmt::format("write the id of one grid, for example {}@201, "
                               "and the effect once more for each other grid",
                               effect.name()));
}

bool holds_all(const std::vector<int>& all, const std::vector<int>& some) {
  return std::ranges::all_of(
      some, [&all](int id) { return std::ranges::find(all, id) != all.end(); });
}

// Any elements of the deck may have lost stiffness, not only the patches that
// the diagnosis tries.
bool are_elements(const structure::Deck& deck, const std::vector<int>& ids) {
  const auto known = [&deck](int id) {
    const auto is = [id](const auto& e) { return e.id == id; };
    return std::ranges::any_of(deck.shells, is) ||
           std::ranges::any_of(deck.bars, is) ||
           std::ranges::any_of(deck.rods, is) ||
           std::ranges::any_of(deck.solids, is);
  };
  return std::ranges::all_of(ids, known);
}

// Of the lines that hold the grids named, the shortest; empty where no grid is
// named or no line holds them.
std::optional<Location> line_through(const std::vector<Location>& places,
                                     const Location& want) {
  std::optional<Location> line;
  if (want.nodes.empty()) return line;
  for (const Location& where : places) {
    if (!holds_all(where.nodes, want.nodes)) continue;
    if (!want.variant.empty() && want.variant != where.variant) continue;
    if (!line || where.nodes.size() < line->nodes.size()) line = where;
  }
  return line;
}

// What a place may be told with.
bool has_variant(const effects::Effect& effect, const std::string& word) {
  if (effect.changes_stiffness() == ChangeKind::Support &&
      effect.variants().empty() &&
      (word == "rotation" || word == "translation")) {
    return true;
  }
  const std::vector<std::string> forms = effect.forms();
  const std::vector<std::string> variants = effect.variants();
  return std::ranges::find(forms, word) != forms.end() ||
         std::ranges::find(variants, word) != variants.end();
}

bool same_channels(const Location& want, const Location& where) {
  return std::ranges::is_permutation(want.channels, where.channels);
}

// A place that is what was asked for, or that needs no asking. An effect that
// may sit at many grids has to be told which; no grid of the sheet means all.
bool is_meant(const Location& want,
              const Location& where,
              const effects::Effect& effect) {
  if (!effect.takes_any_grid() && want.node != where.node) return false;
  // Where a clamp sits that the deck has not has to be told.
  const bool open =
      want.nodes.empty() && !effect.at_sheet_points() && !is_held(where);
  if (!open && want.nodes != where.nodes) return false;
  if (!want.channels.empty() && !same_channels(want, where)) return false;
  if (!holds_all(where.elements, want.elements)) return false;
  return want.variant.empty() || want.variant == where.variant;
}

// The grid that the sheet has the channels at; none where it has several.
std::vector<int> only_grid(const std::vector<Location>& places,
                           const Location& want) {
  std::vector<int> only;
  for (const Location& where : places) {
    if (!same_channels(want, where)) continue;
    if (!only.empty() && only != where.nodes) return {};
    only = where.nodes;
  }
  return only;
}

// The grid, channel or runs of a place that are not there; empty where all are.
std::string missing_part(const Location& where, const effects::TestContext& s) {
  std::vector<int> grids = where.nodes;
  if (where.node != 0) grids.push_back(where.node);
  for (const int grid : grids) {
    if (s.deck != nullptr && !s.deck->has_grid(grid)) {
      return fmt::format("the model has no grid {}", node_name(grid));
    }
  }
  for (const std::string& name : where.channels) {
    const auto& known = s.bundle->channels;
    const bool found =
        std::ranges::find(known, name, &acquisition::Channel::name) !=
        known.end();
    if (!found) return fmt::format("the test has no channel \"{}\"", name);
  }
  return effects::fault_of_runs(where, *s.bundle);
}

// Where an effect may sit.
std::string remedy(const effects::Effect& effect,
                   std::optional<ChangeKind> kind) {
  if (kind == ChangeKind::Elements) {
    return "name shells, bars or rods of the model, joined with \":\"";
  }
  if (kind == ChangeKind::Joint) {
    return "a joint sits along a straight line of shell edges from free edge "
           "to free edge, or at the end of a bar: name grids of one such "
           "line, joined with \":\"";
  }
  if (kind == ChangeKind::Preload) {
    return "name bars or rods in line, or shells of a sheet, joined with "
           "\":\"; a member is pushed (prestress@3:4:compression) only where "
           "both its ends are held";
  }
  if (kind == ChangeKind::Support) {
    return effect.is_mistake()
               ? "name grids that the model holds and how they were free, or "
                 "grids that it leaves free and how they were held (5:10:held)"
               : "name grids that the model holds";
  }
  if (effect.takes_any_grid()) {
    return "name a channel, the grid that the sheet has it at and the one "
           "where it was (acc1:8:6), and runs, if not all (acc1:8:6:run4-6)";
  }
  if (effect.at_sheet_points()) {
    return fmt::format(
        "name a channel, the grid that the sheet has it at, if not all, and "
        "one of {} that the sheet does not have there (acc1:8:{})",
        fmt::join(effect.variants(), ", "),
        effect.variants().front());
  }
  if (effect.corrects_deck()) {
    return fmt::format("name an element with the card, and one of {} (60:{})",
                       fmt::join(effect.variants(), ", "),
                       effect.variants().front());
  }
  if (sits_on_channels(effect)) {
    return "name a channel of the test, or two joined with \":\"";
  }
  return "name a grid of the model that can move, and an axis that was "
         "measured or hit where it is not the one mostly measured (17:X)";
}

// Whether a mistake of the sheet is told in full: its channels, which it is,
// and runs and a grid that there are.
bool names_sheet_place(const effects::Effect& effect,
                       const Location& want,
                       const effects::TestContext& s) {
  if (want.channels.empty()) return false;
  if (!effect.variants().empty() && want.variant.empty()) return false;
  const bool grid =
      s.deck != nullptr && want.node > 0 && s.deck->has_grid(want.node);
  if (effect.takes_any_grid() && !grid) return false;
  return effects::fault_of_runs(want, *s.bundle).empty();
}

// What is written behind the @, for example.
std::string example_place(const effects::Effect& effect) {
  if (effect.corrects_deck()) return "60:" + effect.variants().front();
  if (effect.sits() == effects::Sits::OnElements) return "60:61";
  if (effect.changes_stiffness() == ChangeKind::Joint) return "34:35";
  if (effect.takes_any_grid()) return "acc1:8:6";
  if (effect.at_sheet_points()) return "acc1:" + effect.variants().front();
  return "201";
}

// Throws where no element at the nearest grid holds a place between grids.
void check_holds(const effects::Effect& effect,
                 const Location& where,
                 const effects::TestContext& s) {
  if (where.at.empty() || !motion_between(*s.deck, where, 1).empty()) return;
  throw InputError(
      fmt::format("no bar or shell at grid {} holds the place {:.6g}, {:.6g}, "
                  "{:.6g}",
                  where.node,
                  where.at[0],
                  where.at[1],
                  where.at[2]),
      fmt::format("effect \"{}\"", effect.name()),
      "add it at the grid, without \"at\"");
}

[[noreturn]] void refuse(const EffectRef& ref,
                         std::optional<ChangeKind> kind,
                         const effects::TestContext& context) {
  if (ref.where == Location{}) {
    throw InputError(fmt::format("{} needs a place", ref.effect),
                     fmt::format("effect \"{}\"", ref.effect),
                     fmt::format("write for example {}@{}",
                                 ref.effect,
                                 example_place(effects::find(ref.effect))));
  }
  const std::string missing = missing_part(ref.where, context);
  throw InputError(
      missing.empty() ? fmt::format("{} cannot sit there", ref.effect)
                      : missing,
      fmt::format("effect \"{}{}{}\"",
                  ref.effect,
                  ref.where.node != 0 ? "@" : " at ",
                  ref.where.node != 0 ? fmt::format("{}", ref.where.node)
                                      : describe(ref.where)),
      remedy(effects::find(ref.effect), kind));
}

}  // namespace

std::vector<Location> forms_of(const effects::Effect& effect,
                               const std::vector<Location>& places,
                               const effects::TestContext& context) {
  std::vector<Location> result;
  for (const std::string& form : effect.forms()) {
    for (Location where : places) {
      if (!effect.takes(form, where, context)) continue;
      where.variant = form;
      const bool known = std::ranges::find(result, where) != result.end();
      if (!known) result.push_back(std::move(where));
    }
  }
  return result;
}

EffectRef parse_effect(const std::string& text) {
  const std::size_t at = text.find('@');
  EffectRef ref;
  ref.effect = text.substr(0, at);
  const effects::Effect& effect = effects::find(ref.effect);
  const auto kind = effect.changes_stiffness();
  if (at == std::string::npos) return ref;
  std::string place = text.substr(at + 1);
  if (effect.at_sheet_points()) {
    ref.where = effects::read_sheet_place(parts_of(place), effect);
    return ref;
  }
  const std::size_t end = place.rfind(':');
  const std::string last = place.substr(end == std::string::npos ? 0 : end + 1);
  if (has_variant(effect, last)) {
    ref.where.variant = last;
    if (end == std::string::npos) return ref;
    place.resize(end);
  }
  if (const int point = effect.sits_at_grid() ? test_point_in(place) : 0) {
    ref.where.node = -point;
    return ref;
  }
  check_grid(effect, place, text);
  const std::vector<int> numbers =
      sits_on_channels(effect) ? std::vector<int>{} : numbers_in(place);
  if (!numbers.empty() && effect.sits() == effects::Sits::OnElements) {
    ref.where.elements = numbers;
    std::sort(ref.where.elements.begin(), ref.where.elements.end());
  } else if (!numbers.empty() && kind) {
    ref.where.nodes = numbers;
  } else if (numbers.size() == 1) {
    ref.where.node = numbers.front();
  } else if (!place.empty() && numbers.empty() && !sits_on_channels(effect) &&
             (kind || is_grid(parts_of(place).front()))) {
    throw InputError(
        fmt::format("{} has no form \"{}\"", ref.effect, place),
        fmt::format("effect \"{}\"", text),
        kind == ChangeKind::Support
            ? effect.variants().empty()
                  ? std::string("write rotation, translation, both, face, "
                                "rotation-varying or translation-varying")
                  : fmt::format("write one of {}",
                                fmt::join(effect.variants(), ", "))
        : kind ? "write the ids joined with \":\""
               : "write the grid alone, or added-mass@201:rotary");
  } else if (!place.empty()) {
    ref.where.channels = parts_of(place);
    // A channel that is early, not late.
    if (ref.where.channels.size() > 1 && ref.where.channels.back() == "early") {
      ref.where.channels.pop_back();
      ref.where.variant = "early";
    }
  } else {
    throw InputError("no place after the @",
                     fmt::format("effect \"{}\"", text),
                     "write for example added-mass@201");
  }
  return ref;
}

EffectInstance place_effect(const EffectRef& ref,
                            const effects::TestContext& s) {
  const effects::Effect& effect = effects::find(ref.effect);
  const auto kind = effect.changes_stiffness();
  Location want = on_the_mesh(ref, s);
  if (is_along_axis(want) && effects::component_of(want, s) == s.component) {
    want.variant.clear();
  }
  std::vector<Location> places = effect.places(s);
  for (const Location& form : forms_of(effect, places, s))
    places.push_back(form);
  if (kind == ChangeKind::Elements && !want.elements.empty() &&
      are_elements(*s.deck, want.elements)) {
    return placed(effect, want, s);
  }
  if (want.variant == crack && effect.takes(crack, want, s)) {
    return placed(effect, want, s);
  }
  if (kind) {
    if (const auto line = line_through(places, want)) {
      return placed(effect, *line, s);
    }
  }
  // Any grids may have been held, not only those that the diagnosis tries.
  const bool held = kind == ChangeKind::Support && is_held(want) &&
                    effect.is_mistake() && !want.nodes.empty();
  if (held && missing_part(want, s).empty() &&
      !newly_held(*s.deck, want).empty()) {
    return placed(effect, want, s);
  }
  if (kind == ChangeKind::Preload && are_elements(*s.deck, want.elements) &&
      effects::can_carry(*s.deck, want)) {
    return placed(effect, want, s);
  }
  const bool local = kind && kind != ChangeKind::Support;
  const bool any_grid = effect.takes_any_grid();
  const bool at_sheet = effect.at_sheet_points();
  if (any_grid && want.nodes.empty()) want.nodes = only_grid(places, want);
  for (const Location& where : places) {
    if (local || (at_sheet && !names_sheet_place(effect, want, s))) break;
    if (!is_meant(want, where, effect)) continue;
    if (any_grid && share({want.node}, where.nodes)) continue;
    Location there = where;
    there.at = want.at;
    if (any_grid) there.node = want.node;
    there.runs = want.runs;
    check_holds(effect, there, s);
    return placed(effect, there, s);
  }
  refuse(ref, kind, s);
}

}  // namespace tapfit::updating

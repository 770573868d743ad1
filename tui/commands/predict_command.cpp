#include "signal/files/uff58.hpp"
#include "tui/commands/commands.hpp"
#include "tui/commands/prediction_output.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/outside_files.hpp"
#include "updating/export/point_geometry.hpp"
#include "updating/session/add_diagnosed.hpp"
#include "updating/session/session_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

/// A session whose model is the best known, and what that has.
struct BestKnown {
  updating::Session session;
  std::string source;
};

BestKnown with_named(const CommandOptions& options, const Progress& progress) {
  BestKnown known{open_by_hand(options, progress),
                  "what is uncertain fitted, and"};
  known.session.fit_uncertain(progress);
  for (const std::string& text : options.effects) {
    if (text == "none") continue;
    known.session.add(updating::parse_effect(text), progress);
  }
  if (known.session.effects().empty()) {
    known.source = "what is uncertain fitted, and no effect (--with none)";
  } else {
    known.source += " the effects named by --with";
  }
  return known;
}

// What was added by hand, else what a diagnosis found, else nothing.
BestKnown as_kept(const CommandOptions& options, const Progress& progress) {
  BestKnown known{open_as_kept(options, progress), {}};
  updating::Session& session = known.session;
  if (std::ranges::any_of(session.effects(), &updating::AddedEffect::on)) {
    known.source = "the effects kept in " +
                   updating::session_file(session.bundle()).string();
    return known;
  }
  if (const auto found = session.known_diagnosis(0, progress)) {
    updating::add_ladder(session, *found, progress);
    known.source = found->ladder.empty()
                       ? "what is uncertain fitted: the diagnosis found "
                         "nothing missing"
                       : "the effects that the diagnosis found";
    return known;
  }
  session.fit_uncertain(progress);
  known.source =
      "what is uncertain fitted, and no effect (none is kept; diagnose first "
      "or name them by --with)";
  return known;
}

/// Modes measured after the change, with what was decided of them by hand; no
/// file that test reads is written over.
modal::ModeSet modes_after(const CommandOptions& options,
                           const std::filesystem::path& bundle,
                           const Progress& progress) {
  if (options.inside) updating::check_inside(bundle);
  CommandOptions after = options;
  after.input = bundle;
  after.by_hand = {};
  after.by_hand.session = true;
  return open_by_hand(after, progress).modes(progress);
}

std::string predicted_title(const acquisition::TestBundle& bundle) {
  return bundle.title.empty() ? "predicted" : bundle.title + ", predicted";
}

}  // namespace

std::string predict_command(const CommandOptions& options,
                            const Progress& progress) {
  std::vector<updating::StatedChange> changes;
  for (const std::string& text : options.prediction.changes) {
    changes.push_back(updating::parse_stated_change(text));
  }
  BestKnown known = options.effects.empty() ? as_kept(options, progress)
                                            : with_named(options, progress);
  updating::Session& session = known.session;
  if (options.uff) refuse_modes(session.bundle());
  std::optional<modal::ModeSet> after;
  if (options.prediction.against) {
    after = modes_after(options, *options.prediction.against, progress);
  }
  const updating::Prediction prediction = session.predict(changes, progress);
  if (options.uff) {
    signal::write_frfs_uff(prediction.frfs,
                           predicted_title(session.bundle()),
                           *options.uff,
                           output_rule(session.bundle(), options),
                           signal::FrfForm::Accelerance,
                           updating::point_geometry(session));
  }
  std::optional<updating::Confirmation> seen;
  if (after) {
    seen = updating::confirm(
        prediction, *after, 0.01 * options.prediction.repeatability_percent);
  }
  if (!options.json) {
    return prediction_text(prediction, known.source) +
           (seen ? confirmation_text(*seen, prediction) : "");
  }
  ordered_json json = {{"bundle", options.input.string()},
                       {"model", known.source}};
  json.update(prediction_json(prediction));
  json["against"] = nullptr;
  if (seen) json["against"] = confirmation_json(*seen, prediction);
  for (const std::string& odd : input_warnings(session)) {
    json["warnings"].push_back(odd);
  }
  return json_text(json);
}

}  // namespace tapfit::tui

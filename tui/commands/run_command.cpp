#include "acquisition/bundle/channel_names.hpp"
#include "tui/commands/commands.hpp"
#include "tui/commands/compare_command.hpp"
#include "tui/commands/diagnose_command.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/hits_text.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/modes_text.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

/// Bundles of ready FRFs or modes have no hits.
acquisition::HitSet hits_of(updating::Session& session,
                            const Progress& progress) {
  return session.bundle().runs.empty() ? acquisition::HitSet{}
                                       : session.hits(progress);
}

std::string whole_json(updating::Session& session,
                       const CommandOptions& options,
                       const Progress& progress) {
  ordered_json json;
  json["hits"] = hits_json(session.bundle(), hits_of(session, progress));
  json["frf"] = frf_json(session.frfs(progress));
  json["modes"] = modes_json(session.modes(progress),
                             acquisition::channel_names(session.bundle()));
  json["compare"] = nullptr;
  json["diagnose"] = nullptr;
  if (session.has_model()) {
    json["compare"] = compare_json(session.base_comparison(progress),
                                   session.frfs(),
                                   session.modes().dofs);
    json["diagnose"] = diagnosis_json(
        options.input,
        with_input_warnings(session.diagnosis(progress), session));
  }
  return json_text(json);
}

std::string run_text(updating::Session& session, const Progress& progress) {
  std::string text = session.bundle().title + "\n";
  if (!session.bundle().runs.empty()) {
    text += "\n" + hits_text(session.bundle(), session.hits(progress));
  }
  if (!session.bundle().modes) {
    text += "\n" + frf_text(session.frfs(progress));
  }
  text += "\n" + modes_text(session.modes(progress),
                            acquisition::channel_names(session.bundle()));
  if (!session.has_model()) {
    return text +
           "\nThe bundle names no model: the work ends with the modes.\n";
  }
  text += "\n" + compare_text(session.base_comparison(progress),
                              session.frfs(),
                              session.modes().dofs);
  return text + "\n" + diagnosis_text(session.diagnosis(progress));
}

}  // namespace

std::string run_command(const CommandOptions& options,
                        const Progress& progress) {
  updating::Session session = open_by_hand(options, progress);
  return options.json ? whole_json(session, options, progress)
                      : run_text(session, progress);
}

}  // namespace tapfit::tui

#include "tui/commands/free_masses.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mass_loading/loaded_frf_model.hpp"
#include "signal/files/uff58.hpp"
#include "signal/mass_removal/named_masses.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "updating/export/point_geometry.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

const char* freed_word(signal::FreedBy by) {
  switch (by) {
    case signal::FreedBy::Measurement:
      return "measurement";
    case signal::FreedBy::Model:
      return "modes";
    case signal::FreedBy::NoNeed:
      return "no need";
    case signal::FreedBy::NotFreed:
      break;
  }
  return "no";
}

/// What is free of the masses, for the file.
signal::FrfSet free_ones(const signal::FreedFrfs& freed) {
  signal::FrfSet set = freed.frfs;
  set.frfs.clear();
  for (std::size_t f = 0; f < freed.notes.size(); ++f) {
    if (freed.notes[f].by != signal::FreedBy::NotFreed) {
      set.frfs.push_back(freed.frfs.frfs[f]);
    }
  }
  return set;
}

void write_free_ones(const signal::FreedFrfs& freed,
                     updating::Session& session,
                     const CommandOptions& options) {
  const signal::FrfSet set = free_ones(freed);
  if (set.frfs.empty()) {
    throw InputError(
        "no FRF can be freed of the masses: " + freed.notes.front().reason,
        "--free",
        "hit the sensors' own places too");
  }
  signal::write_frfs_uff(set,
                         session.bundle().title + ", sensors' mass taken off",
                         *options.uff,
                         output_rule(session.bundle(), options),
                         signal::FrfForm::Accelerance,
                         updating::point_geometry(session));
}

}  // namespace

ordered_json freed_json(const signal::FrfSet& measured,
                        const signal::FreedFrfs& freed,
                        const std::vector<signal::KnownMass>& masses) {
  ordered_json json = frf_json(freed.frfs);
  for (std::size_t f = 0; f < freed.notes.size(); ++f) {
    ordered_json& own = json["frfs"][f];
    own["freed"] = freed_word(freed.notes[f].by);
    if (!freed.notes[f].reason.empty()) own["reason"] = freed.notes[f].reason;
    own["measured_sd_percent"] = median_sd_percent(measured.frfs[f]);
  }
  ordered_json list = ordered_json::array();
  for (const signal::KnownMass& mass : masses) {
    list.push_back(
        {{"of", mass.name}, {"mass_kg", mass.kg}, {"sd_kg", mass.sd_kg}});
  }
  json["masses"] = std::move(list);
  return json;
}

std::string freed_text(const signal::FrfSet& measured,
                       const signal::FreedFrfs& freed,
                       const std::vector<signal::KnownMass>& masses) {
  std::string text = "FRFs without the mass of";
  for (const signal::KnownMass& mass : masses) {
    text += fmt::format(
        " {} ({:.4g} +- {:.2g} g)", mass.name, 1e3 * mass.kg, 1e3 * mass.sd_kg);
  }
  TextTable table({"<response / reference",
                   "run",
                   "sd measured",
                   "sd freed",
                   "<  freed by",
                   "<because"});
  for (std::size_t f = 0; f < freed.notes.size(); ++f) {
    const signal::Frf& frf = freed.frfs.frfs[f];
    const bool is_free = freed.notes[f].by != signal::FreedBy::NotFreed;
    table.add({name(frf),
               fmt::format("{}", frf.run + 1),
               percent(median_sd_percent(measured.frfs[f]) / 100.0),
               is_free ? percent(median_sd_percent(frf) / 100.0) : "-",
               fmt::format("  {}", freed_word(freed.notes[f].by)),
               freed.notes[f].reason});
  }
  text += "\n" + table.text();
  for (const std::string& statement : measured.statements) {
    text += "  note: " + statement + "\n";
  }
  return text +
         "  note: a mass is taken off in the directions that are "
         "measured at its place\n";
}

std::string free_masses(updating::Session& session,
                        const CommandOptions& options,
                        const Progress& progress) {
  const signal::FrfSet& frfs = session.frfs(progress);
  const signal::LoadedTest loaded =
      signal::masses_to_free(session.bundle(), frfs, options.free);
  // Modes are identified only where something was not measured.
  signal::FrfModel from_modes;
  const auto model = [&](std::size_t set_up, const Dof& a, const Dof& b) {
    if (!from_modes) {
      from_modes = modal::loaded_frf_model(session.modes(progress), frfs);
    }
    return from_modes(set_up, a, b);
  };
  const signal::FreedFrfs freed =
      signal::free_frfs(frfs, loaded, model, progress);
  if (options.uff) {
    write_free_ones(freed, session, options);
  }
  return options.json ? json_text(freed_json(frfs, freed, loaded.masses))
                      : freed_text(frfs, freed, loaded.masses);
}

}  // namespace tapfit::tui

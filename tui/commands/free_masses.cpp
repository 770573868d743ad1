#include "tui/commands/free_masses.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mass_loading/loaded_frf_model.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/frf_command.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

std::optional<double> parse_kg(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value) || value < 0.0) {
    return std::nullopt;
  }
  return value;
}

signal::KnownMass known_mass(const FreeWord& word, std::optional<double> own) {
  const std::optional<double> kg = word.kg ? word.kg : own;
  if (!kg || !(*kg > 0.0)) {
    throw InputError(fmt::format("the mass of {} is not known", word.what),
                     "--free",
                     fmt::format("give it in kg, --free {}=0.020, or as "
                                 "mass_kg of the channel in test.json",
                                 word.what));
  }
  return {word.what, *kg, word.sd_kg};
}

/// What "all" stands for.
std::vector<FreeWord> all_declared(const acquisition::TestBundle& bundle) {
  std::vector<FreeWord> words;
  for (const acquisition::Channel& channel : bundle.channels) {
    if (channel.mass_kg && *channel.mass_kg > 0.0) {
      words.push_back({channel.name, channel.mass_kg, 0.0});
    }
  }
  if (words.empty()) {
    throw InputError("no channel states its mass",
                     "--free all",
                     "name the sensors with their mass, --free acc1=0.020, or "
                     "add mass_kg to the channels in test.json");
  }
  return words;
}

std::string channel_names(const acquisition::TestBundle& bundle) {
  std::string names;
  for (const acquisition::Channel& channel : bundle.channels) {
    if (channel.quantity == acquisition::Quantity::Force) continue;
    names += (names.empty() ? "" : ", ") + channel.name;
  }
  return names.empty() ? "a point such as 12Z+=0.020" : names;
}

/// Channels and points among the words.
struct Named {
  std::vector<signal::ChannelMass> channels;
  std::vector<signal::PointMass> points;
};

void add_word(const acquisition::TestBundle& bundle,
              const FreeWord& word,
              Named& named) {
  const auto channel = std::ranges::find(
      bundle.channels, word.what, &acquisition::Channel::name);
  if (channel != bundle.channels.end() &&
      channel->quantity != acquisition::Quantity::Force) {
    const auto index =
        static_cast<std::size_t>(channel - bundle.channels.begin());
    named.channels.push_back({index, known_mass(word, channel->mass_kg)});
    return;
  }
  const std::optional<Dof> dof = parse_dof(word.what);
  if (!dof) {
    throw InputError(fmt::format("no sensor is called \"{}\"", word.what),
                     "--free",
                     "use one of " + channel_names(bundle));
  }
  named.points.push_back({*dof, known_mass(word, std::nullopt)});
}

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
                     const std::string& title,
                     const std::filesystem::path& file) {
  const signal::FrfSet set = free_ones(freed);
  if (set.frfs.empty()) {
    throw InputError(
        "no FRF can be freed of the masses: " + freed.notes.front().reason,
        "--free",
        "hit the sensors' own places too");
  }
  signal::write_frfs_uff(set, title + ", sensors' mass taken off", file);
}

}  // namespace

std::optional<FreeWord> parse_free(const std::string& text) {
  FreeWord word;
  const std::size_t comma = text.find(',');
  const std::string first = text.substr(0, comma);
  if (comma != std::string::npos) {
    const std::string rest = text.substr(comma + 1);
    const auto sd =
        rest.starts_with("sd=") ? parse_kg(rest.substr(3)) : std::nullopt;
    if (!sd) return std::nullopt;
    word.sd_kg = *sd;
  }
  const std::size_t equals = first.find('=');
  word.what = first.substr(0, equals);
  if (word.what.empty()) return std::nullopt;
  if (equals != std::string::npos) {
    word.kg = parse_kg(first.substr(equals + 1));
    if (!word.kg || !(*word.kg > 0.0)) return std::nullopt;
  }
  return word;
}

signal::LoadedTest masses_to_free(const acquisition::TestBundle& bundle,
                                  const signal::FrfSet& frfs,
                                  const std::vector<std::string>& words) {
  Named named;
  for (const std::string& text : words) {
    const std::optional<FreeWord> word = parse_free(text);
    if (!word) {
      throw InputError(fmt::format("\"{}\" names no mass", text),
                       "--free",
                       "write acc1, acc1=0.020 or acc1=0.020,sd=0.001 (in kg)");
    }
    if (word->what != "all") {
      add_word(bundle, *word, named);
      continue;
    }
    if (word->kg) {
      throw InputError("all sensors have no mass in common",
                       fmt::format("--free all={:g}", *word->kg),
                       "--free all takes each channel's mass_kg of test.json; "
                       "else name the sensors, --free acc1=0.020");
    }
    for (FreeWord own : all_declared(bundle)) {
      own.sd_kg = word->sd_kg;
      add_word(bundle, own, named);
    }
  }
  if (named.points.empty()) {
    return signal::sensors_as_loads(frfs, named.channels);
  }
  if (!named.channels.empty()) {
    throw InputError("channels and points cannot be freed together",
                     "--free",
                     "name the sensors only, or the points only");
  }
  return signal::points_as_loads(frfs, named.points);
}

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
      masses_to_free(session.bundle(), frfs, options.free);
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
    write_free_ones(freed, session.bundle().title, *options.uff);
  }
  return options.json ? freed_json(frfs, freed, loaded.masses).dump(2) + "\n"
                      : freed_text(frfs, freed, loaded.masses);
}

}  // namespace tapfit::tui

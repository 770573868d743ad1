#include "signal/mass_removal/named_masses.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tapfit::signal {

namespace {

std::optional<double> parse_kg(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value) || value < 0.0) {
    return std::nullopt;
  }
  return value;
}

KnownMass known_mass(const FreeWord& word, std::optional<double> own) {
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
  std::vector<ChannelMass> channels;
  std::vector<PointMass> points;
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

LoadedTest masses_to_free(const acquisition::TestBundle& bundle,
                          const FrfSet& frfs,
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
    return sensors_as_loads(frfs, named.channels);
  }
  if (!named.channels.empty()) {
    throw InputError("channels and points cannot be freed together",
                     "--free",
                     "name the sensors only, or the points only");
  }
  return points_as_loads(frfs, named.points);
}

}  // namespace tapfit::signal

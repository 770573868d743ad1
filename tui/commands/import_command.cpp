#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/import_recordings.hpp"
#include "acquisition/import/propose_import.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/output_rule_of_folder.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace tapfit::tui {

namespace {

using acquisition::ImportChannel;
using acquisition::ImportFile;
using acquisition::Quantity;

InputError spec_error(const std::string& text, const std::string& what) {
  return {what,
          fmt::format("\"{}\"", text),
          "write COLUMN@POINT,KEY=VALUE,... for example 2@12Z+,unit=g"};
}

double number(const std::string& text, const std::string& value) {
  double result = 0.0;
  const char* end = value.data() + value.size();
  const auto [stop, fault] = std::from_chars(value.data(), end, result);
  if (fault != std::errc{} || stop != end || !std::isfinite(result)) {
    throw spec_error(text, fmt::format("\"{}\" is no number", value));
  }
  return result;
}

void set_key(ImportChannel& channel,
             const std::string& text,
             const std::string& key,
             const std::string& value) {
  if (key == "name") {
    channel.channel = value;
  } else if (key == "unit") {
    channel.unit = value;
  } else if (key == "volts_per_unit") {
    channel.volts_per_unit = number(text, value);
  } else if (key == "mass_kg") {
    channel.mass_kg = number(text, value);
  } else if (key == "flip") {
    channel.flip_sign = true;
  } else {
    throw spec_error(text, fmt::format("unknown key \"{}\"", key));
  }
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

// Reads "COLUMN@POINT[,KEY=VALUE ...]", for example
// "2@12Z+,unit=g,name=acc1,mass_kg=0.02". Keys: name, unit, volts_per_unit,
// mass_kg, flip.
ImportChannel parse_import_channel(const std::string& text, Quantity quantity) {
  const std::vector<std::string> parts = split_at_commas(text);
  const std::size_t at = parts.front().rfind('@');
  const auto dof = at == std::string::npos
                       ? std::nullopt
                       : parse_dof(parts.front().substr(at + 1));
  if (!dof || dof->node < 1) {
    throw spec_error(text, "names no point of the structure");
  }

  ImportChannel channel;
  channel.column = parts.front().substr(0, at);
  channel.channel = channel.column;
  channel.quantity = quantity;
  channel.dof = *dof;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::size_t equals = parts[k].find('=');
    const std::string value =
        equals == std::string::npos ? "" : parts[k].substr(equals + 1);
    set_key(channel, text, parts[k].substr(0, equals), value);
  }
  return channel;
}

// Reads "FILE" or "FILE@POINT", the point where this file's blows fell.
ImportFile parse_import_file(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at != std::string::npos) {
    const auto dof = parse_dof(text.substr(at + 1));
    if (dof && dof->node > 0) {
      return {.file = text.substr(0, at), .hammer = dof};
    }
  }
  return {.file = text, .hammer = std::nullopt};
}

// What the command line says; what it leaves open is empty.
acquisition::ImportOptions options_of(const CommandOptions& options) {
  const ImportArguments& arguments = options.imports;
  acquisition::ImportOptions result;
  for (const auto& file : arguments.files) {
    result.files.push_back(parse_import_file(file));
  }
  if (!arguments.hammer.empty()) {
    result.hammer = parse_import_channel(arguments.hammer, Quantity::Force);
  }
  for (const auto& sensor : arguments.sensors) {
    result.sensors.push_back(
        parse_import_channel(sensor, Quantity::Acceleration));
  }
  double rate = 0.0;
  const char* end = arguments.rate.data() + arguments.rate.size();
  const auto [stop, fault] = std::from_chars(arguments.rate.data(), end, rate);
  if (fault == std::errc{} && stop == end) {
    result.sample_rate_hz = rate;
  } else if (!arguments.rate.empty()) {
    result.rate_variable = arguments.rate;
  }
  if (!arguments.time_column.empty()) {
    result.time_column = arguments.time_column;
  }
  result.title = arguments.title;
  result.deck = options.deck;
  result.band_hz = arguments.band_hz;
  // Called after the first file, in the working folder.
  result.folder = options.output.value_or(result.files.front().file.stem());
  result.rule = updating::output_rule_of_folder(result.folder, options.force);
  if (options.deck) {
    for (auto& file : structure::deck_files(*options.deck)) {
      result.rule.inputs.push_back(std::move(file));
    }
  }
  return result;
}

nlohmann::ordered_json bundle_json(
    const acquisition::TestBundle& bundle,
    const acquisition::ImportProposal& proposal) {
  nlohmann::ordered_json json{{"bundle", bundle.folder.string()},
                              {"runs", bundle.runs.size()},
                              {"found", proposal.found},
                              {"assumed", nlohmann::ordered_json::array()},
                              {"warnings", bundle.warnings}};
  for (const acquisition::ImportAssumption& assumed : proposal.assumptions) {
    json["assumed"].push_back({{"what", assumed.what},
                               {"option", assumed.option},
                               {"field", assumed.field}});
  }
  return json;
}

std::string channel_lines(const acquisition::TestBundle& bundle) {
  std::string text;
  const acquisition::Run& run = bundle.runs.front();
  const auto add = [&](const char* role, const acquisition::Placement& at) {
    const acquisition::Channel& channel = bundle.channels.at(at.channel);
    text += fmt::format("  {}  \"{}\" at {}, {} in {}, {:.6g} V per {}\n",
                        role,
                        channel.name,
                        name(at.dof),
                        acquisition::name(channel.quantity),
                        channel.unit,
                        channel.sensitivity,
                        channel.unit);
  };
  add("hammer", run.hammer);
  for (const acquisition::Placement& sensor : run.sensors) {
    add("sensor", sensor);
  }
  return text;
}

// How to say otherwise.
std::string remedy_text(const acquisition::ImportAssumption& assumed) {
  if (assumed.field.empty()) return assumed.option;
  const std::string field = assumed.field + " in test.json";
  return assumed.option.empty() ? field : assumed.option + "; or " + field;
}

std::string plain_text(const acquisition::TestBundle& bundle,
                       const acquisition::ImportProposal& proposal) {
  std::string text = fmt::format("Bundle {} written, {} runs\n",
                                 bundle.folder.string(),
                                 bundle.runs.size());
  if (!proposal.found.empty() || !proposal.assumptions.empty()) {
    text += channel_lines(bundle);
  }
  for (const std::string& line : proposal.found) {
    text += fmt::format("  {}\n", line);
  }
  for (const acquisition::ImportAssumption& assumed : proposal.assumptions) {
    text += fmt::format("  assumed: {}\n    to say otherwise: {}\n",
                        assumed.what,
                        remedy_text(assumed));
  }
  for (const std::string& warning : bundle.warnings) {
    text += fmt::format("  note: {}\n", warning);
  }
  return text +
         "  note: the files do not say the channels' ranges; full_scale_volts "
         "is room above the largest value, and overload is told by flat tops "
         "alone\n";
}

}  // namespace

std::string import_command(const CommandOptions& options,
                           const Progress& progress) {
  progress("importing", 0.0);
  acquisition::ImportProposal proposal;
  proposal.options = options_of(options);
  if (options.imports.hammer.empty() || options.imports.sensors.empty()) {
    proposal = acquisition::propose_import(proposal.options, progress);
  }
  const auto bundle =
      acquisition::import_recordings(proposal.options, progress);
  return options.json ? json_text(bundle_json(bundle, proposal))
                      : plain_text(bundle, proposal);
}

}  // namespace tapfit::tui

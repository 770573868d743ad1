#include "tui/commands/import_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/export/output_rule_of_folder.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>

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
  if (fault != std::errc{} || stop != end) {
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

}  // namespace

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

std::string import_command(const CommandOptions& options,
                           const Progress& progress) {
  progress("importing", 0.0);
  const ImportArguments& arguments = options.imports;
  acquisition::ImportOptions import_options;
  for (const auto& file : arguments.files) {
    import_options.files.push_back(parse_import_file(file));
  }
  import_options.hammer =
      parse_import_channel(arguments.hammer, Quantity::Force);
  for (const auto& sensor : arguments.sensors) {
    import_options.sensors.push_back(
        parse_import_channel(sensor, Quantity::Acceleration));
  }
  double rate = 0.0;
  const char* end = arguments.rate.data() + arguments.rate.size();
  const auto [stop, fault] = std::from_chars(arguments.rate.data(), end, rate);
  if (fault == std::errc{} && stop == end) {
    import_options.sample_rate_hz = rate;
  } else if (!arguments.rate.empty()) {
    import_options.rate_variable = arguments.rate;
  }
  import_options.time_column = arguments.time_column;
  import_options.title = arguments.title;
  import_options.deck = options.deck;
  import_options.band_hz = arguments.band_hz;
  import_options.folder = options.output.value_or("");
  import_options.rule =
      updating::output_rule_of_folder(import_options.folder, options.force);
  if (options.deck) {
    for (auto& file : structure::deck_files(*options.deck)) {
      import_options.rule.inputs.push_back(std::move(file));
    }
  }
  const auto bundle = acquisition::import_recordings(import_options);
  if (options.json) {
    const nlohmann::ordered_json json{{"bundle", bundle.folder.string()},
                                      {"runs", bundle.runs.size()},
                                      {"warnings", bundle.warnings}};
    return json.dump(2) + "\n";
  }
  return fmt::format(
      "Bundle {} written, {} runs\n"
      "  note: the files do not say the channels' ranges; full_scale_volts is "
      "room above the largest value, and overload is told by flat tops alone\n",
      bundle.folder.string(),
      bundle.runs.size());
}

}  // namespace tapfit::tui

#include "acquisition/import/import_recordings.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/import/import_tables.hpp"
#include "acquisition/readers/audio_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;

// The channel's unit: as given, else as the files say, else the usual one.
std::string unit_of(const ImportChannel& channel,
                    const std::vector<ImportTable>& tables,
                    std::size_t column) {
  if (!channel.unit.empty()) return channel.unit;
  std::string unit = tables[0].units.at(column);
  const auto said = [](const std::string& text) {
    return text.empty() ? "no unit" : text;
  };
  for (const ImportTable& table : tables) {
    if (table.units.at(column) == unit) continue;
    throw InputError(fmt::format("column \"{}\" is in {} in one file and in {} "
                                 "in another",
                                 channel.column,
                                 said(unit),
                                 said(table.units.at(column))),
                     "import",
                     "import them apart, or say which it is: unit=UNIT behind "
                     "COLUMN@POINT");
  }
  const bool in_volts = unit == "V" && channel.volts_per_unit;
  if (!unit.empty() && !in_volts) return unit;
  return channel.quantity == Quantity::Force ? "N" : "m/s^2";
}

// Power of two with at least a quarter of room above the largest value, so
// that no sample looks like an overload and scaling loses no digit.
double full_scale(const std::vector<ImportTable>& tables, Index column) {
  double largest = 0.0;
  for (const ImportTable& table : tables) {
    largest = std::max(largest, table.values.col(column).cwiseAbs().maxCoeff());
  }
  if (largest == 0.0) return 1.0;
  return std::exp2(std::ceil(std::log2(1.25 * largest)));
}

Channel bundle_channel(const ImportChannel& source, double scale) {
  const std::optional<Unit> unit = find_unit(source.unit);
  if (!unit || unit->quantity != source.quantity) {
    throw InputError(fmt::format("\"{}\" is no known unit of {}",
                                 source.unit,
                                 name(source.quantity)),
                     fmt::format("column \"{}\"", source.column),
                     "use one of " + known_units(source.quantity));
  }
  Channel channel;
  channel.name = source.channel;
  channel.quantity = source.quantity;
  channel.unit = source.unit;
  channel.unit_to_si = unit->si;
  // What was divided by it is multiplied again: test.json then holds the
  // sensor's own sensitivity.
  const double recorded = source.recorded_volts_per_unit.value_or(1.0);
  channel.sensitivity = source.volts_per_unit.value_or(recorded);
  channel.full_scale_volts = source.volts_per_unit ? scale : scale * recorded;
  channel.mass_kg = source.mass_kg;
  return channel;
}

Run bundle_run(const ImportFile& source,
               const ImportOptions& options,
               const fs::path& file) {
  Run run;
  run.file = file;
  run.hammer = {0, source.hammer.value_or(options.hammer.dof)};
  for (std::size_t k = 0; k < options.sensors.size(); ++k) {
    run.sensors.push_back({k + 1, options.sensors[k].dof});
  }
  return run;
}

// A sensor that was not connected, or a column that is another's.
std::vector<std::string> dead_columns(const ImportOptions& options,
                                      const std::vector<ImportTable>& tables) {
  const std::vector<ImportChannel> channels = all_channels(options);
  std::vector<std::string> notes;
  for (std::size_t r = 0; r < tables.size(); ++r) {
    for (std::size_t k = 0; k < channels.size(); ++k) {
      if (!tables[r].values.col(static_cast<Index>(k)).isZero(0.0)) continue;
      notes.push_back(
          fmt::format("{}: column \"{}\" ({}) is zero throughout; check that "
                      "it is the right one",
                      tables[r].source->file.filename().string(),
                      channels[k].column,
                      channels[k].channel));
    }
  }
  return notes;
}

// "run-01.csv" becomes "run-01.wav", the second of several runs in "taps.h5"
// "taps-2.wav"; a name used before gets a number.
std::string sound_file(const ImportTable& table, std::set<std::string>& used) {
  std::string stem = table.source->file.stem().string();
  if (table.run > 0) stem += fmt::format("-{}", table.run);
  std::string result = stem + ".wav";
  for (int i = 2; !used.insert(result).second; ++i) {
    result = fmt::format("{}-{}.wav", stem, i);
  }
  return result;
}

// As given, and that what is imported is an input.
OutputRule output_rule(const ImportOptions& options) {
  OutputRule rule = options.rule;
  for (const ImportFile& source : options.files) {
    rule.inputs.push_back(source.file);
  }
  if (options.deck) rule.inputs.push_back(*options.deck);
  return rule;
}

}  // namespace

void check_import(const ImportOptions& options) {
  std::error_code ignored;
  if (fs::exists(options.folder / "test.json", ignored)) {
    throw InputError("there is a test already, which is never written over",
                     options.folder.string(),
                     "choose another folder, or take that one away first");
  }
  // Before the first is read: that may take a while.
  for (const ImportFile& source : options.files) {
    if (fs::is_regular_file(source.file, ignored)) continue;
    check_input(source.file);
    throw InputError("no such file",
                     source.file.string(),
                     "check its path; nothing has been imported");
  }
  if (options.deck && !fs::is_regular_file(*options.deck, ignored)) {
    check_input(*options.deck);
    throw InputError("no such file",
                     options.deck->string(),
                     "name the Nastran deck, or import without one");
  }
}

TestBundle import_recordings(const ImportOptions& options,
                             const Progress& progress) {
  if (options.files.empty() || options.sensors.empty()) {
    throw InputError("nothing to import",
                     "import",
                     "name at least one file and one sensor's column");
  }
  check_import(options);
  const std::vector<ImportTable> tables = read_import_tables(options, progress);
  TestBundle bundle;
  bundle.title = options.title;
  if (options.deck) bundle.deck = fs::absolute(*options.deck);
  bundle.band_hz = options.band_hz;
  bundle.block_s = options.block_s;
  const std::vector<ImportChannel> channels = all_channels(options);
  Eigen::RowVectorXd scale(static_cast<Index>(channels.size()));
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const double volts = full_scale(tables, column);
    ImportChannel channel = channels[k];
    channel.unit = unit_of(channel, tables, k);
    bundle.channels.push_back(bundle_channel(channel, volts));
    scale[column] = (channels[k].flip_sign ? -1.0 : 1.0) / volts;
  }
  OutputFolder output(options.folder, output_rule(options));
  std::set<std::string> used;
  for (std::size_t r = 0; r < tables.size(); ++r) {
    progress("writing",
             static_cast<double>(r) / static_cast<double>(tables.size()));
    const std::string name = sound_file(tables[r], used);
    output.write(name, [&](const fs::path& file) {
      write_audio(file,
                  tables[r].values * scale.asDiagonal(),
                  tables[r].rate,
                  AudioFormat::WavFloat64);
    });
    bundle.runs.push_back(
        bundle_run(*tables[r].source, options, options.folder / name));
  }
  progress("writing", 1.0);
  output.write("test.json", [&](const fs::path& file) {
    write_file(file, test_bundle_text(bundle, options.folder), {});
    // What no command could read is not put in its place.
    (void)read_test_bundle(file);
  });
  output.commit();
  TestBundle written = read_test_bundle(options.folder);
  for (const ImportTable& table : tables) {
    std::ranges::copy(table.notes, std::back_inserter(written.warnings));
  }
  for (std::string& note : dead_columns(options, tables)) {
    written.warnings.push_back(std::move(note));
  }
  return written;
}

}  // namespace tapfit::acquisition

#include "acquisition/import/import_recordings.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/foundation/output_rule.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/readers/named_array.hpp"
#include "acquisition/samples/rate_of_times.hpp"
#include "acquisition/samples/statistics.hpp"

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

std::vector<ImportChannel> all_channels(const ImportOptions& options) {
  std::vector<ImportChannel> channels{options.hammer};
  channels.insert(
      channels.end(), options.sensors.begin(), options.sensors.end());
  return channels;
}

// Says where a column of times leaves its step: with a gap, all times up to it
// are far from a straight line through the ends.
[[noreturn]] void refuse_uneven(const Eigen::VectorXd& time,
                                const std::string& file) {
  const Index n = time.size();
  const Eigen::VectorXd steps = time.tail(n - 1) - time.head(n - 1);
  const double usual = median(steps);
  Index row = 0;
  (steps.array() - usual).abs().maxCoeff(&row);
  throw InputError(
      fmt::format("the sampling is uneven: from row {} of the numbers to the "
                  "next it goes on by {:.6g} s (at {:.6g} s), elsewhere by "
                  "{:.6g} s",
                  row + 1,
                  steps[row],
                  time[row],
                  usual),
      file,
      "export without gaps, or cut the file at the gap");
}

// The sampling rate from a column of times; each time may be half a step off.
RateOfTimes rate_of(const Eigen::VectorXd& time, const std::string& file) {
  const auto rate = rate_of_times(time);
  if (!rate) {
    throw InputError("the time column does not rise",
                     file,
                     "name the column that holds seconds, or give the rate");
  }
  if (rate->uneven) refuse_uneven(time, file);
  return *rate;
}

[[noreturn]] void refuse_rate(double rate,
                              bool from_times,
                              const std::string& file) {
  throw InputError(
      fmt::format("is sampled at {:.8g} Hz, which is no whole number: the "
                  "sound files of a bundle cannot say it",
                  rate),
      file,
      from_times ? "give the sampling rate if the times are rounded, or "
                   "resample to a whole number of Hz"
                 : "resample to a whole number of Hz, or give the records as a "
                   "universal file (dataset 58, with their points): that keeps "
                   "the rate and is a bundle by itself");
}

// Sound files hold whole numbers of Hz. Times printed with few digits give the
// rate with few digits, and so do multiples of a step of four; a rate that is
// stated is what it is.
int whole_rate(double rate,
               const std::optional<double>& spread,
               const std::string& file,
               std::vector<std::string>& notes) {
  if (!(rate > 0.0) || !(rate < 1e9)) {
    throw InputError(fmt::format("has a sampling rate of {:.6g} Hz", rate),
                     file,
                     "give the sampling rate in Hz, a number above zero");
  }
  constexpr double exact = 1e-6;
  const double whole = std::round(rate);
  const double off = std::abs(rate - whole) / rate;
  const double allowed = spread ? std::max(1e-4, *spread) : exact;
  if (whole < 1.0 || off > allowed) refuse_rate(rate, spread.has_value(), file);
  if (off > exact) {
    notes.push_back(
        fmt::format("{}: its times give {:.8g} Hz; {:.0f} Hz are taken, since "
                    "sound files hold whole numbers of Hz",
                    file,
                    rate,
                    whole));
  }
  return static_cast<int>(whole);
}

struct Table {
  int rate = 0;
  Eigen::MatrixXd values;          ///< n_rows x (1 + sensors), as in the file
  std::vector<std::string> units;  ///< as the file says, may be empty
  std::vector<std::string> notes;  ///< on the times and the rate
};

// The columns, and behind them a column of times where it is to tell the rate.
//
// @param rate set to what a variable of the file says
TimeTable read_source(const ImportFile& source,
                      const ImportOptions& options,
                      std::vector<std::string> columns,
                      const Progress& progress,
                      std::optional<double>& rate) {
  if (!is_instrument_file(source.file)) {
    if (options.rate_variable) {
      throw InputError(fmt::format("\"{}\" is no rate in Hz, and this file has "
                                   "no variables",
                                   *options.rate_variable),
                       source.file.string(),
                       "give the sampling rate in Hz");
    }
    if (!rate && !says_rate(source.file)) {
      columns.push_back(options.time_column.value_or("1"));
    }
    return read_time_table(source.file, columns, options.csv, progress);
  }
  const InstrumentFile file = read_instrument_file(source.file, progress);
  if (!rate && options.rate_variable) {
    rate = number_of(file.arrays, *options.rate_variable, source.file);
  }
  if (!rate && options.time_column) columns.push_back(*options.time_column);
  return table_of(file, columns);
}

Table read_table(const ImportFile& source,
                 const ImportOptions& options,
                 const Progress& progress) {
  std::vector<std::string> columns;
  for (const ImportChannel& channel : all_channels(options)) {
    columns.push_back(channel.column);
  }
  const std::string file = source.file.string();
  const auto count = static_cast<Index>(columns.size());
  std::optional<double> rate = options.sample_rate_hz;
  TimeTable read = read_source(source, options, columns, progress, rate);
  std::optional<double> spread;
  if (!rate && read.values.cols() > count) {
    const RateOfTimes timed = rate_of(read.values.col(count), file);
    rate = timed.hz;
    spread = timed.spread;
  } else if (!rate) {
    rate = read.rate_hz;
    spread = read.rate_spread;
  }
  if (!rate) refuse_without_rate(source.file);
  Table table;
  table.notes = std::move(read.notes);
  table.rate = whole_rate(*rate, spread, file, table.notes);
  table.units = std::move(read.units);
  table.values = std::move(read.values);
  table.values.conservativeResize(Eigen::NoChange, count);
  return table;
}

// The channel's unit: as given, else as the files say, else the usual one.
std::string unit_of(const ImportChannel& channel,
                    const std::vector<Table>& tables,
                    std::size_t column) {
  if (!channel.unit.empty()) return channel.unit;
  std::string unit = tables[0].units.at(column);
  const auto said = [](const std::string& text) {
    return text.empty() ? "no unit" : text;
  };
  for (const Table& table : tables) {
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
double full_scale(const std::vector<Table>& tables, Index column) {
  double largest = 0.0;
  for (const Table& table : tables) {
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
                                      const std::vector<Table>& tables) {
  const std::vector<ImportChannel> channels = all_channels(options);
  std::vector<std::string> notes;
  for (std::size_t r = 0; r < tables.size(); ++r) {
    for (std::size_t k = 0; k < channels.size(); ++k) {
      if (!tables[r].values.col(static_cast<Index>(k)).isZero(0.0)) continue;
      notes.push_back(
          fmt::format("{}: column \"{}\" ({}) is zero throughout; check that "
                      "it is the right one",
                      options.files[r].file.filename().string(),
                      channels[k].column,
                      channels[k].channel));
    }
  }
  return notes;
}

// "run-01.csv" becomes "run-01.wav"; a name used before gets a number.
fs::path sound_file(const ImportFile& source, std::set<std::string>& used) {
  const std::string stem = source.file.stem().string();
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

void refuse_without_rate(const fs::path& file) {
  throw InputError(
      "does not say its sampling rate in times that rise evenly, "
      "a rate or a step",
      file.string(),
      "give it with --rate HZ or --rate VARIABLE, or name the "
      "times with --time");
}

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
  std::vector<Table> tables;
  for (const ImportFile& file : options.files) {
    tables.push_back(read_table(file, options, progress));
  }
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
    const std::string name = sound_file(options.files[r], used);
    output.write(name, [&](const fs::path& file) {
      write_audio(file,
                  tables[r].values * scale.asDiagonal(),
                  tables[r].rate,
                  AudioFormat::WavFloat64);
    });
    bundle.runs.push_back(
        bundle_run(options.files[r], options, options.folder / name));
  }
  progress("writing", 1.0);
  output.write("test.json", [&](const fs::path& file) {
    write_file(file, test_bundle_text(bundle, options.folder), {});
    // What no command could read is not put in its place.
    (void)read_test_bundle(file);
  });
  output.commit();
  TestBundle written = read_test_bundle(options.folder);
  for (Table& table : tables) {
    std::ranges::move(table.notes, std::back_inserter(written.warnings));
  }
  for (std::string& note : dead_columns(options, tables)) {
    written.warnings.push_back(std::move(note));
  }
  return written;
}

}  // namespace tapfit::acquisition

#include "acquisition/import/import_tables.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "acquisition/readers/named_array.hpp"
#include "acquisition/samples/rate_of_times.hpp"
#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

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

// What to say of times that give a rate at which no hammer test is sampled.
std::string other_unit(double rate) {
  constexpr double slow = 20.0;
  if (rate >= slow) return {};
  return fmt::format(
      "times in ms are {:.8g} Hz: name their column with the "
      "unit, such as \"t [ms]\", or give --rate {:.8g}",
      1e3 * rate,
      1e3 * rate);
}

[[noreturn]] void refuse_rate(double rate,
                              bool from_times,
                              const std::string& file) {
  std::string unit = other_unit(rate);
  if (!unit.empty()) unit = "; " + unit;
  throw InputError(
      fmt::format("is sampled at {:.8g} Hz, which is no whole number: the "
                  "sound files of a bundle cannot say it",
                  rate),
      file,
      from_times ? "give the sampling rate if the times are rounded, or "
                   "resample to a whole number of Hz" +
                       unit
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
  const std::string unit = spread ? other_unit(rate) : "";
  if (!unit.empty()) {
    notes.push_back(
        fmt::format("{}: its times give {:.8g} Hz; {}", file, rate, unit));
  }
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

// What is to be read of a file: the columns, and the rate as it was given.
struct Wanted {
  std::vector<std::string> columns;
  std::optional<double> rate;
};

// Of a file without variables, with a column of times where it is to tell the
// rate.
TimeTable read_plain_source(const ImportFile& source,
                            const ImportOptions& options,
                            std::vector<std::string> columns,
                            const Progress& progress) {
  if (options.rate_variable) {
    throw InputError(fmt::format("\"{}\" is no rate in Hz, and this file has "
                                 "no variables",
                                 *options.rate_variable),
                     source.file.string(),
                     "give the sampling rate in Hz");
  }
  if (!options.sample_rate_hz && !says_rate(source.file)) {
    columns.push_back(options.time_column.value_or("1"));
  }
  return read_time_table(source.file, columns, options.csv, progress);
}

// @param read the columns, and behind them one of times where that is to tell
//   the rate
ImportTable finish_table(const ImportFile& source,
                         const Wanted& wanted,
                         TimeTable read) {
  const std::string file = source.file.string();
  const auto count = static_cast<Index>(wanted.columns.size());
  std::optional<double> rate = wanted.rate;
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
  ImportTable table;
  table.source = &source;
  table.notes = std::move(read.notes);
  table.rate = whole_rate(*rate, spread, file, table.notes);
  table.units = std::move(read.units);
  table.values = std::move(read.values);
  table.values.conservativeResize(Eigen::NoChange, count);
  return table;
}

// One table for each run that the columns name.
std::vector<ImportTable> read_runs(const ImportFile& source,
                                   const ImportOptions& options,
                                   Wanted wanted,
                                   const Progress& progress) {
  const InstrumentFile file = read_instrument_file(source.file, progress);
  if (!wanted.rate && options.rate_variable) {
    wanted.rate = number_of(file.arrays, *options.rate_variable, source.file);
  }
  std::vector<std::string> columns = wanted.columns;
  const std::vector<std::size_t> runs = runs_named(file, columns);
  if (!wanted.rate && options.time_column) {
    columns.push_back(*options.time_column);
  }
  std::vector<ImportTable> tables;
  for (const std::size_t run : runs) {
    tables.push_back(
        finish_table(source, wanted, table_of(file, columns, run)));
    if (runs.size() > 1) tables.back().run = run + 1;
  }
  for (const std::string& what : file.left_out) {
    tables[0].notes.push_back(
        fmt::format("{}: {}", source.file.filename().string(), what));
  }
  return tables;
}

}  // namespace

std::vector<ImportChannel> all_channels(const ImportOptions& options) {
  std::vector<ImportChannel> channels{options.hammer};
  channels.insert(
      channels.end(), options.sensors.begin(), options.sensors.end());
  return channels;
}

void refuse_without_rate(const std::filesystem::path& file) {
  throw InputError(
      "does not say its sampling rate in times that rise evenly, "
      "a rate or a step",
      file.string(),
      "give it with --rate HZ or --rate VARIABLE, or name the "
      "times with --time; a column of times in ms says so: \"t [ms]\"");
}

std::vector<ImportTable> read_import_tables(const ImportOptions& options,
                                            const Progress& progress) {
  Wanted wanted{{}, options.sample_rate_hz};
  for (const ImportChannel& channel : all_channels(options)) {
    wanted.columns.push_back(channel.column);
  }
  std::vector<ImportTable> tables;
  for (const ImportFile& source : options.files) {
    if (is_instrument_file(source.file)) {
      std::ranges::move(read_runs(source, options, wanted, progress),
                        std::back_inserter(tables));
      continue;
    }
    tables.push_back(finish_table(
        source,
        wanted,
        read_plain_source(source, options, wanted.columns, progress)));
  }
  return tables;
}

}  // namespace tapfit::acquisition

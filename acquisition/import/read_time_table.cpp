#include "acquisition/import/read_time_table.hpp"

#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/sep005.hpp"
#include "acquisition/readers/time_units.hpp"
#include "acquisition/uff/uff_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

const UffDataset& pick(const std::vector<const UffDataset*>& records,
                       const std::string& column,
                       const std::string& file) {
  const int number = integer(column);
  if (number >= 1 && static_cast<std::size_t>(number) <= records.size()) {
    return *records[static_cast<std::size_t>(number) - 1];
  }
  if (records.empty()) {
    throw InputError("holds no time records (dataset 58, function type 1)",
                     file,
                     "export the time records; tapfit uff FILE lists what it "
                     "holds");
  }
  throw InputError(
      fmt::format("there is no time record \"{}\"", column),
      file,
      fmt::format("give a number from 1 to {}; tapfit uff FILE lists them",
                  records.size()));
}

TimeTable read_uff_table(const UffFile& file,
                         const std::vector<std::string>& columns) {
  const std::vector<const UffDataset*> records = uff_time_records(file);
  TimeTable table;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const UffDataset& dataset = pick(records, columns[k], file.name);
    const UffFunction record = read_function(dataset);
    const double rate = rate_of(record);
    if (k == 0) {
      table.rate_hz = rate;
      table.values.resize(record.count, static_cast<Index>(columns.size()));
    }
    if (!record.even || record.count != table.values.rows() ||
        rate != *table.rate_hz) {
      throw InputError("the record is sampled otherwise than the first one",
                       dataset.place,
                       "import records of one recording together");
    }
    table.values.col(static_cast<Index>(k)) = record.y.real();
    const std::string& unit = record.numerator.unit;
    table.units.push_back(unit == "NONE" ? "" : unit);
  }
  return table;
}

void millivolts_to_volts(TimeTable& table) {
  for (std::size_t k = 0; k < table.units.size(); ++k) {
    if (table.units[k] != "mV") continue;
    table.values.col(static_cast<Index>(k)) *= 1e-3;
    table.units[k] = "V";
  }
}

void times_to_seconds(const std::filesystem::path& file,
                      const std::vector<std::string>& columns,
                      TimeTable& table) {
  for (std::size_t k = 0; k < table.units.size(); ++k) {
    const double seconds = seconds_in(table.units[k]).value_or(1.0);
    if (seconds == 1.0) continue;
    table.values.col(static_cast<Index>(k)) *= seconds;
    table.notes.push_back(
        fmt::format("{}: the times of column \"{}\" are in {}, as it says",
                    file.string(),
                    columns[k],
                    table.units[k]));
    table.units[k] = "s";
  }
}

TimeTable read_plain_table(const std::filesystem::path& file,
                           const std::vector<std::string>& columns,
                           const CsvOptions& options,
                           const Progress& progress) {
  if (is_uff(file)) {
    const UffFile uff = open_uff(file);
    return uff.bytes.reading([&] { return read_uff_table(uff, columns); });
  }
  if (is_sep005(file)) return read_sep005(file, columns);
  CsvTable table = read_csv_table(file, columns, options, progress);
  return {std::move(table.values), std::move(table.units), {}, {}};
}

// The first rate that is told holds for all.
void take_rate(const TimeRecord& record,
               const std::filesystem::path& file,
               TimeTable& table) {
  if (!table.rate_hz) {
    table.rate_hz = record.rate_hz;
    table.rate_spread = record.rate_spread;
  }
  const double rate = table.rate_hz.value_or(0.0);
  if (std::abs(record.rate_hz.value_or(rate) - rate) <= 1e-6 * rate) return;
  throw InputError(
      fmt::format("\"{}\" is sampled at {:.8g} Hz, others at {:.8g} Hz",
                  record.column,
                  *record.rate_hz,
                  rate),
      file,
      "name channels of one recording");
}

}  // namespace

std::vector<const UffDataset*> uff_time_records(const UffFile& file) {
  std::vector<const UffDataset*> records;
  for (const UffDataset& dataset : file.datasets) {
    if (dataset.type == 58 && function_type(dataset) == 1) {
      records.push_back(&dataset);
    }
  }
  return records;
}

bool is_sep005(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending == ".json";
}

bool says_rate(const std::filesystem::path& file) {
  return is_sep005(file) || is_uff(file);
}

std::vector<std::size_t> runs_named(const InstrumentFile& file,
                                    const std::vector<std::string>& columns) {
  std::optional<std::size_t> alone;
  std::string first;
  bool by_channel = false;
  for (const std::string& column : columns) {
    by_channel = by_channel || find_record(file.records, column) != nullptr;
    for (std::size_t run = 0; run <= file.later_runs.size(); ++run) {
      const auto& records = records_of(file, run);
      if (std::ranges::count(records, column, &TimeRecord::column) == 0) {
        continue;
      }
      if (alone && *alone != run) {
        throw InputError(
            fmt::format(
                "\"{}\" and \"{}\" are of different runs", first, column),
            file.file.string(),
            "name channels of one recording");
      }
      alone = run;
      first = column;
    }
  }
  if (alone) return {*alone};
  std::vector<std::size_t> runs{0};
  for (std::size_t k = 1; k <= file.later_runs.size() && by_channel; ++k) {
    runs.push_back(k);
  }
  return runs;
}

TimeTable table_of(const InstrumentFile& file,
                   const std::vector<std::string>& columns,
                   std::size_t run) {
  TimeTable table;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const TimeRecord record = take_record(file, columns[k], run);
    if (k == 0) {
      table.values.resize(record.values.size(),
                          static_cast<Index>(columns.size()));
    }
    if (record.values.size() != table.values.rows()) {
      throw InputError(fmt::format("\"{}\" has {} samples, \"{}\" has {}",
                                   columns[k],
                                   record.values.size(),
                                   columns[0],
                                   table.values.rows()),
                       file.file.string(),
                       "name channels of one recording");
    }
    take_rate(record, file.file, table);
    table.values.col(static_cast<Index>(k)) = record.values;
    table.units.push_back(record.unit);
  }
  return table;
}

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns,
                          const CsvOptions& options,
                          const Progress& progress) {
  TimeTable table =
      is_instrument_file(file)
          ? table_of(read_instrument_file(file, progress), columns)
          : read_plain_table(file, columns, options, progress);
  millivolts_to_volts(table);
  times_to_seconds(file, columns, table);
  return table;
}

}  // namespace tapfit::acquisition

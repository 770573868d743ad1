#include "acquisition/import/read_time_records.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "acquisition/import/sep005.hpp"
#include "acquisition/instruments/point_names.hpp"
#include "acquisition/instruments/sampling.hpp"
#include "acquisition/instruments/usual_names.hpp"
#include "acquisition/readers/time_units.hpp"
#include "acquisition/samples/rate_of_times.hpp"
#include "acquisition/uff/uff_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Channels as their file tells of them, without samples.
std::vector<TimeRecord> list_channels(const std::filesystem::path& file,
                                      const CsvOptions& options) {
  std::vector<TimeRecord> channels;
  const auto add = [&](const std::string& name, const std::string& unit) {
    TimeRecord channel;
    channel.column = std::to_string(channels.size() + 1);
    channel.name = name.empty() ? "channel " + channel.column : name;
    channel.unit = unit;
    channel.dof = point_in_name(name);
    channels.push_back(std::move(channel));
  };
  if (is_uff(file)) {
    const UffFile uff = open_uff(file);
    const auto headers = uff.bytes.reading([&] {
      std::vector<UffHeader> all;
      for (const UffDataset* dataset : uff_time_records(uff)) {
        all.push_back(read_header(*dataset));
      }
      return all;
    });
    for (const UffHeader& header : headers) {
      add(header.response ? name(*header.response) : "", "");
      channels.back().dof = header.response;
    }
  } else if (is_sep005(file)) {
    for (const std::string& name : sep005_names(file)) add(name, "");
  } else {
    for (const CsvColumn& column : list_csv_columns(file, options)) {
      add(column.name, column.unit);
      channels.back().column = column.number;
    }
  }
  return channels;
}

bool is_times(const TimeRecord& record) {
  return usual_name(record.name) == UsualName::Time ||
         seconds_in(record.unit) || is_axis(record.values);
}

// A column of times is none of the channels and tells their rate.
//
// @return that column; empty where there is none
std::string take_times_out(std::vector<TimeRecord>& records) {
  std::string column;
  std::optional<RateOfTimes> rate;
  for (const TimeRecord& record : records) {
    if (!is_times(record) || rate) continue;
    const auto here = rate_of_times(record.values);
    // Numbers of samples tell nothing.
    if (here && here->hz == 1.0) continue;
    column = record.column;
    if (here && !here->uneven) rate = here;
  }
  for (TimeRecord& record : records) {
    if (!rate) break;
    record.rate_hz = rate->hz;
    record.rate_spread = rate->spread;
  }
  std::erase_if(records, is_times);
  return column;
}

void make_names_differ(std::vector<TimeRecord>& records) {
  std::set<std::string> used;
  for (TimeRecord& record : records) {
    const std::string name = record.name;
    for (int k = 2; !used.insert(record.name).second; ++k) {
      record.name = fmt::format("{} {}", name, k);
    }
  }
}

void read_plain_records(const std::filesystem::path& file,
                        const CsvOptions& options,
                        const Progress& progress,
                        InstrumentFile& result) {
  std::vector<TimeRecord>& records = result.records;
  records = list_channels(file, options);
  std::vector<std::string> columns;
  for (const TimeRecord& record : records) columns.push_back(record.column);
  if (records.empty()) return;
  const TimeTable table = read_time_table(file, columns, options, progress);
  for (std::size_t k = 0; k < records.size(); ++k) {
    TimeRecord& record = records[k];
    record.values = table.values.col(static_cast<Index>(k));
    if (!table.units[k].empty()) record.unit = table.units[k];
    record.rate_hz = table.rate_hz;
    record.rate_spread = table.rate_spread;
  }
  if (!says_rate(file)) result.time_column = take_times_out(records);
  make_names_differ(records);
}

}  // namespace

InstrumentFile read_time_records(const std::filesystem::path& file,
                                 const CsvOptions& options,
                                 const Progress& progress) {
  InstrumentFile result{file, {}, {}, 0, {}};
  if (is_instrument_file(file)) {
    result = read_instrument_file(file, progress);
  } else {
    read_plain_records(file, options, progress, result);
  }
  if (!result.records.empty()) return result;
  throw InputError("holds no records of channels over time",
                   file.string(),
                   "export the time records of hammer and sensors");
}

}  // namespace tapfit::acquisition

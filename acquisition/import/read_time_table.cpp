#include "acquisition/import/read_time_table.hpp"

#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/sep005.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "acquisition/uff/uff_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

std::string ending(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

// Time records of a universal file, in its order.
std::vector<const UffDataset*> time_records(const UffFile& file) {
  std::vector<const UffDataset*> records;
  for (const UffDataset& dataset : file.datasets) {
    if (dataset.type == 58 && function_type(dataset) == 1) {
      records.push_back(&dataset);
    }
  }
  return records;
}

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
  const std::vector<const UffDataset*> records = time_records(file);
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

}  // namespace

bool says_rate(const std::filesystem::path& file) {
  return ending(file) == ".json" || is_uff(file);
}

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns,
                          const CsvOptions& options) {
  if (is_uff(file)) {
    const UffFile uff = open_uff(file);
    return uff.bytes.reading([&] { return read_uff_table(uff, columns); });
  }
  if (ending(file) == ".json") return read_sep005(file, columns);
  TimeTable table;
  table.values = ending(file) == ".mat"
                     ? read_mat_columns(file, columns)
                     : read_csv_columns(file, columns, options);
  table.units.resize(columns.size());
  return table;
}

}  // namespace tapfit::acquisition

#include "acquisition/instruments/known_layouts.hpp"

#include "acquisition/foundation/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Arrays = std::vector<NamedArray>;
using Kind = NamedArray::Kind;

constexpr std::string_view testlab_values = ".y_values.values";

std::vector<std::string> texts_at(const Arrays& all, const std::string& name) {
  const NamedArray* array = find_array(all, name);
  return array != nullptr && array->kind == Kind::Text
             ? array->texts
             : std::vector<std::string>();
}

std::optional<double> value_at(const Arrays& all, const std::string& name) {
  const NamedArray* array = find_array(all, name);
  const bool fits = array != nullptr && array->kind == Kind::Numbers &&
                    array->values.size() == 1;
  return fits ? std::optional(array->values(0, 0)) : std::nullopt;
}

// The k-th of a list, or the only one of it.
std::string text_of(const std::vector<std::string>& texts, std::size_t k) {
  if (texts.size() == 1) return texts[0];
  return k < texts.size() ? texts[k] : std::string();
}

// "Signal" of "Signal.y_values.values"; empty for other arrays.
std::string testlab_base(const NamedArray& array) {
  const std::string& name = array.name;
  return name.size() > testlab_values.size() && name.ends_with(testlab_values)
             ? name.substr(0, name.size() - testlab_values.size())
             : std::string();
}

bool over_time(const Arrays& all, const std::string& base) {
  const std::string axis =
      text_of(texts_at(all, base + ".x_values.quantity.label"), 0);
  return axis.empty() || axis == "s";
}

void add_testlab(const Arrays& all,
                 const NamedArray& values,
                 const std::string& base,
                 std::vector<TimeRecord>& records) {
  const auto step = value_at(all, base + ".x_values.increment");
  const auto names = texts_at(all, base + ".function_record.name");
  const auto units = texts_at(all, base + ".y_values.quantity.label");
  for (Index k = 0; k < values.columns(); ++k) {
    const auto place = static_cast<std::size_t>(k);
    TimeRecord record;
    record.column = values.columns() == 1
                        ? values.name
                        : fmt::format("{}:{}", values.name, k + 1);
    record.name = place < names.size() ? names[place] : "";
    if (record.name.empty()) {
      record.name =
          values.columns() == 1 ? base : fmt::format("{} {}", base, k + 1);
    }
    record.unit = text_of(units, place);
    if (step && *step > 0.0) record.rate_hz = 1.0 / *step;
    record.values = values.column(k);
    records.push_back(std::move(record));
  }
}

// What rattlesnake's table says of a channel.
std::string cell(const Arrays& all, const char* column, std::size_t channel) {
  const auto texts = texts_at(all, fmt::format("channels/{}", column));
  return channel < texts.size() ? texts[channel] : std::string();
}

std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (fault != std::errc{} || stop != end) return std::nullopt;
  return value;
}

TimeRecord rattlesnake_record(const Arrays& all, std::size_t channel) {
  const std::string node = cell(all, "node_number", channel);
  const std::string direction = cell(all, "node_direction", channel);
  TimeRecord record;
  record.name = fmt::format(
      "{} {} {}", cell(all, "channel_type", channel), node, direction);
  record.name.erase(0, record.name.find_first_not_of(' '));
  record.name.erase(record.name.find_last_not_of(' ') + 1);
  record.unit = cell(all, "unit", channel);
  if (const auto id = number_in(node); id && *id >= 1.0 && *id < 1e8) {
    record.dof = parse_direction(static_cast<int>(*id), direction);
  }
  const auto millivolts = number_in(cell(all, "sensitivity", channel));
  if (millivolts && *millivolts != 0.0 && find_unit(record.unit)) {
    record.volts_per_unit = 1e-3 * std::abs(*millivolts);
  }
  return record;
}

}  // namespace

bool is_testlab(const Arrays& all) {
  for (const NamedArray& array : all) {
    const std::string base = testlab_base(array);
    if (base.empty()) continue;
    if (find_array(all, base + ".x_values.increment") != nullptr) return true;
  }
  return false;
}

std::vector<TimeRecord> testlab_records(const Arrays& all) {
  std::vector<TimeRecord> records;
  for (const NamedArray& array : all) {
    const std::string base = testlab_base(array);
    if (base.empty() || array.kind != Kind::Numbers || array.samples() < 2 ||
        !over_time(all, base)) {
      continue;
    }
    add_testlab(all, array, base, records);
  }
  return records;
}

bool is_rattlesnake(const Arrays& all) {
  const NamedArray* data = find_array(all, "time_data");
  const auto units = texts_at(all, "channels/unit");
  return data != nullptr && data->kind == Kind::Numbers && !units.empty() &&
         (data->values.cols() == static_cast<Index>(units.size()) ||
          data->values.rows() == static_cast<Index>(units.size()));
}

std::vector<TimeRecord> rattlesnake_records(const Arrays& all) {
  const NamedArray& data = *find_array(all, "time_data");
  const std::size_t channels = texts_at(all, "channels/unit").size();
  const bool in_columns = data.values.cols() == static_cast<Index>(channels);
  const auto rate = value_at(all, "sample_rate");
  std::vector<TimeRecord> records;
  for (std::size_t k = 0; k < channels; ++k) {
    const auto place = static_cast<Index>(k);
    TimeRecord record = rattlesnake_record(all, k);
    record.column =
        channels == 1 ? "time_data" : fmt::format("time_data:{}", k + 1);
    if (rate && *rate > 0.0) record.rate_hz = rate;
    if (in_columns) {
      record.values = data.values.col(place);
    } else {
      record.values = data.values.row(place).transpose();
    }
    records.push_back(std::move(record));
  }
  return records;
}

Index rattlesnake_frame(const Arrays& all) {
  if (!is_rattlesnake(all)) return 0;
  for (const NamedArray& array : all) {
    // Only files of frames hold the FRFs that were made of them.
    constexpr std::string_view frfs = "/frf_data_real";
    if (!array.name.ends_with(frfs)) continue;
    const std::string group =
        array.name.substr(0, array.name.size() - frfs.size());
    const double frame =
        value_at(all, group + "@samples_per_frame").value_or(0.0);
    const Index samples = find_array(all, "time_data")->samples();
    const auto length = static_cast<Index>(
        std::clamp(frame, 0.0, static_cast<double>(samples)));
    if (length > 1 && samples % length == 0) return length;
  }
  return 0;
}

}  // namespace tapfit::acquisition

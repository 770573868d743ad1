#include "acquisition/import/sep005.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/samples/rate_of_times.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using nlohmann::json;

// Python writes what is not finite as NaN and Infinity, which JSON does not
// know: where in a list the text before such a word has come.
InputError refusal(const std::filesystem::path& file,
                   const json::parse_error& error) {
  std::ifstream in(file, std::ios::binary);
  std::string text(error.byte + 8, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  const std::size_t at = std::max<std::size_t>(1, error.byte) - 1;
  const std::string_view rest = std::string_view(text).substr(at);
  if (!rest.starts_with("NaN") && !rest.starts_with("Infinity")) {
    return {error.what(), file.string(), "correct the JSON"};
  }
  const std::string_view before = std::string_view(text).substr(0, at);
  const std::size_t list = before.rfind('[');
  const auto index = list == std::string_view::npos
                         ? 0
                         : std::ranges::count(before.substr(list), ',');
  return {fmt::format("value {} of a list is no finite number ({}, byte {})",
                      index + 1,
                      rest.front() == 'N' ? "NaN" : "Infinity",
                      error.byte),
          file.string(),
          "cut the record there, or export the measurement again"};
}

json parse(const std::filesystem::path& file) {
  std::ifstream in = open_input(file, most_table_bytes());
  if (!in) {
    throw InputError("cannot be opened", file.string(), "correct the path");
  }
  json document;
  try {
    document = json::parse(in);
  } catch (const json::parse_error& error) {
    throw refusal(file, error);
  } catch (const json::exception& error) {
    throw InputError(error.what(), file.string(), "correct the JSON");
  }
  // One signal may stand alone.
  if (document.is_object() && document.contains("data")) {
    document = json::array({document});
  }
  if (!document.is_array() || document.empty()) {
    throw InputError("is no list of signals",
                     file.string(),
                     "give a list of objects with data, name, unit_str and fs");
  }
  return document;
}

InputError fault(const std::filesystem::path& file,
                 std::size_t entry,
                 const std::string& key,
                 const std::string& what) {
  return {what,
          fmt::format("{}: [{}].{}", file.string(), entry, key),
          "each signal needs data (a list of numbers), name, unit_str, and fs "
          "or time"};
}

Eigen::VectorXd list_of(const json& signal,
                        const char* key,
                        const std::filesystem::path& file,
                        std::size_t entry) {
  if (!signal.is_object() || !signal.contains(key) || !signal[key].is_array()) {
    throw fault(file, entry, key, "there is no list of numbers");
  }
  const json& list = signal[key];
  Eigen::VectorXd values(static_cast<Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_number()) {
      throw fault(file, entry, fmt::format("{}[{}]", key, i), "is no number");
    }
    values[static_cast<Index>(i)] = list[i].get<double>();
  }
  return values;
}

double stated_rate(const json& signal,
                   const std::filesystem::path& file,
                   std::size_t entry) {
  if (signal["fs"].is_number() && signal["fs"].get<double>() > 0.0) {
    return signal["fs"].get<double>();
  }
  throw fault(file, entry, "fs", "is no rate above zero");
}

RateOfTimes timed_rate(const json& signal,
                       const std::filesystem::path& file,
                       std::size_t entry) {
  const auto rate = rate_of_times(list_of(signal, "time", file, entry));
  if (!rate) throw fault(file, entry, "time", "does not rise");
  if (rate->uneven) {
    throw fault(file,
                entry,
                fmt::format("time[{}]", *rate->uneven),
                "is not evenly spaced");
  }
  return *rate;
}

std::string text_of(const json& signal, const char* key) {
  return signal.is_object() && signal.contains(key) && signal[key].is_string()
             ? printable(signal[key].get<std::string>())
             : std::string();
}

std::size_t find(const json& document,
                 const std::string& column,
                 const std::filesystem::path& file) {
  std::string known;
  for (std::size_t i = 0; i < document.size(); ++i) {
    const std::string name = text_of(document[i], "name");
    if (name == column || std::to_string(i + 1) == column) return i;
    if (!name.empty()) known += name + ", ";
  }
  throw InputError(fmt::format("there is no signal \"{}\"", column),
                   file.string(),
                   fmt::format("use {}{}a number from 1 to {}",
                               known,
                               known.empty() ? "" : "or ",
                               document.size()));
}

}  // namespace

std::vector<std::string> sep005_names(const std::filesystem::path& file) {
  std::vector<std::string> names;
  for (const json& signal : parse(file)) {
    names.push_back(text_of(signal, "name"));
  }
  return names;
}

TimeTable read_sep005(const std::filesystem::path& file,
                      const std::vector<std::string>& columns) {
  const json document = parse(file);
  TimeTable table;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::size_t entry = find(document, columns[k], file);
    const json& signal = document[entry];
    const Eigen::VectorXd data = list_of(signal, "data", file, entry);
    std::optional<RateOfTimes> timed;
    if (!signal.contains("fs")) timed = timed_rate(signal, file, entry);
    const double rate = timed ? timed->hz : stated_rate(signal, file, entry);
    if (k == 0) {
      table.rate_hz = rate;
      if (timed) table.rate_spread = timed->spread;
      table.values.resize(data.size(), static_cast<Index>(columns.size()));
    }
    if (data.size() == 0 || data.size() != table.values.rows()) {
      throw fault(file,
                  entry,
                  "data",
                  fmt::format("has {} samples, that of \"{}\" has {}",
                              data.size(),
                              columns[0],
                              table.values.rows()));
    }
    if (std::abs(rate - *table.rate_hz) > 1e-6 * rate) {
      throw fault(file, entry, "fs", "differs from the first signal's");
    }
    table.values.col(static_cast<Index>(k)) = data;
    table.units.push_back(text_of(signal, "unit_str"));
  }
  return table;
}

}  // namespace tapfit::acquisition

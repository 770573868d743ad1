#include "acquisition/instruments/file_runs.hpp"

#include "acquisition/foundation/units.hpp"
#include "acquisition/instruments/array_records.hpp"
#include "acquisition/instruments/known_layouts.hpp"
#include "acquisition/instruments/point_names.hpp"
#include "acquisition/instruments/run_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Arrays = std::vector<NamedArray>;

std::string array_of(const TimeRecord& record) {
  return record.column.substr(0, record.column.rfind(':'));
}

// The records under one key, and what names each within it.
struct Part {
  std::string key;
  std::vector<TimeRecord> records = {};
  std::vector<std::string> channels = {};

  [[nodiscard]] const TimeRecord* find(const std::string& channel) const {
    const auto at = std::ranges::find(channels, channel);
    return at == channels.end()
               ? nullptr
               : &records[static_cast<std::size_t>(at - channels.begin())];
  }
};

bool is_in_force(const TimeRecord& record) {
  const std::optional<Unit> unit = find_unit(record.unit);
  return unit && unit->quantity == Quantity::Force;
}

// The arrays of one key and those of none, but for records of their own.
Arrays arrays_under(const Arrays& all, KeyOf key_of, const std::string& key) {
  Arrays part;
  for (const NamedArray& array : all) {
    const std::string base = array.name.substr(0, array.name.find('@'));
    const std::optional<RunKey> place = key_of(base);
    const bool is_own = place && place->key == key;
    const bool is_shared =
        (!place || place->channel.empty()) && !is_record_array(all, array);
    const bool fits = is_own || is_shared;
    if (fits) part.push_back(array);
  }
  return part;
}

// The last part of a channel's place, where its name comes from its place.
void name_by_channel(const std::string& channel, TimeRecord& record) {
  if (!record.column.ends_with(record.name) || channel.empty()) return;
  const std::size_t at = channel.find_last_of("/.");
  record.name = at + 1 < channel.size() ? channel.substr(at + 1) : channel;
  if (channel[0] == ':') record.name = "channel " + channel.substr(1);
  record.dof = point_in_name(record.name);
}

std::vector<Part> parts_by_name(const Arrays& all, KeyOf key_of) {
  std::vector<std::string> keys;
  std::map<std::string, Index> columns;
  for (const NamedArray& array : all) {
    if (!is_record_array(all, array)) continue;
    const std::optional<RunKey> place = key_of(array.name);
    if (!place) continue;
    if (!columns.contains(place->key)) keys.push_back(place->key);
    columns[place->key] += array.columns();
  }
  sort_by_number(keys);
  std::vector<Part> parts;
  for (const std::string& key : keys) {
    Part part{key};
    // One channel is no run.
    if (keys.size() > 1 && columns[key] > 1)
      part.records = records_of_arrays(arrays_under(all, key_of, key));
    for (TimeRecord& record : part.records) {
      const std::string array = array_of(record);
      part.channels.push_back(key_of(array)->channel +
                              record.column.substr(array.size()));
      name_by_channel(part.channels.back(), record);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// By the columns of arrays that all have as many, called by no list of names.
std::vector<Part> parts_by_column(const std::vector<TimeRecord>& flat) {
  std::vector<Part> parts;
  for (const TimeRecord& record : flat) {
    const std::string array = array_of(record);
    if (array.size() == record.column.size() ||
        !record.column.ends_with(record.name)) {
      continue;
    }
    const std::string key = record.column.substr(array.size() + 1);
    auto part = std::ranges::find(parts, key, &Part::key);
    if (part == parts.end()) part = parts.insert(part, Part{key});
    part->channels.push_back(array);
    part->records.push_back(record);
    name_by_channel(array, part->records.back());
  }
  return parts;
}

// Testlab's structures by how often a name came before, which is made a number
// behind it.
std::vector<Part> parts_by_repetition(const std::vector<TimeRecord>& flat) {
  std::vector<Part> parts;
  std::set<std::string> names;
  for (const TimeRecord& record : flat) {
    names.insert(record.name);
    const std::size_t at = record.name.rfind(' ');
    const bool again =
        at != std::string::npos && names.contains(record.name.substr(0, at));
    const std::string key = again ? record.name.substr(at + 1) : "1";
    auto part = std::ranges::find(parts, key, &Part::key);
    if (part == parts.end()) part = parts.insert(part, Part{key});
    part->channels.push_back(again ? record.name.substr(0, at) : record.name);
    part->records.push_back(record);
  }
  return parts;
}

// Channels that all parts have.
std::vector<std::string> common_channels(const std::vector<Part>& parts) {
  std::vector<std::string> common = parts[0].channels;
  std::erase_if(common, [&](const std::string& channel) {
    return !std::ranges::all_of(
        parts, [&](const Part& part) { return part.find(channel); });
  });
  return common;
}

// Keeps the parts that hold the channel which is in a unit of force most often.
bool keep_with_force(std::vector<Part>& parts) {
  std::string hammer;
  std::ptrdiff_t most = 1;
  const auto holds = [](const Part& part, const std::string& channel) {
    const TimeRecord* record = part.find(channel);
    return record != nullptr && is_in_force(*record);
  };
  for (const Part& part : parts) {
    for (const std::string& channel : part.channels) {
      const auto count = std::ranges::count_if(
          parts, [&](const Part& p) { return holds(p, channel); });
      if (count <= most) continue;
      most = count;
      hammer = channel;
    }
  }
  if (most < 2) return false;
  std::erase_if(parts, [&](const Part& part) { return !holds(part, hammer); });
  return true;
}

std::string quoted_keys(const std::vector<Part>& parts) {
  std::vector<std::string> keys;
  for (const Part& part : parts) {
    if (keys.size() < 3) keys.push_back(fmt::format("\"{}\"", part.key));
  }
  if (parts.size() > 3) keys.back() = "...";
  return fmt::format("{}", fmt::join(keys, ", "));
}

struct Judgement {
  std::vector<FileRun> runs = {};
  std::string doubt = {};
};

Judgement runs_of(std::vector<Part>& parts,
                  const std::vector<std::string>& channels) {
  Judgement result;
  for (Part& part : parts) {
    FileRun run{part.key, {}};
    for (const std::string& channel : channels) {
      const auto at = std::ranges::find(part.channels, channel);
      run.records.push_back(std::move(
          part.records[static_cast<std::size_t>(at - part.channels.begin())]));
      if (result.runs.empty()) continue;
      run.records.back().name =
          result.runs[0].records[run.records.size() - 1].name;
    }
    result.runs.push_back(std::move(run));
  }
  return result;
}

// Whether parts are runs. A run has a hammer: by a unit of force in each, or,
// where the file has none, by its name; or the keys say that they are runs.
Judgement judge(std::vector<Part> parts, const std::vector<TimeRecord>& flat) {
  const bool force = keep_with_force(parts);
  if (!force && std::ranges::any_of(flat, is_in_force)) return {};
  const std::size_t before = parts.size();
  std::erase_if(parts, [](const Part& p) { return p.records.size() < 2; });
  if (parts.size() < 2) return {};
  const std::vector<std::string> common = common_channels(parts);
  if (common.size() < 2) {
    if (!force) return {};
    return {{},
            fmt::format("{} each hold a force, and otherwise no channels of "
                        "the same names",
                        quoted_keys(parts))};
  }
  std::size_t held = 0;
  std::vector<std::string> keys;
  for (const Part& part : parts) {
    held += part.records.size();
    keys.push_back(part.key);
  }
  const bool sure = force || std::ranges::any_of(common, sounds_like_hammer) ||
                    sound_like_runs(keys);
  if (sure) return runs_of(parts, common);
  // Something stands beside them, which may be the hammer.
  if (before > parts.size() || held < flat.size()) return {};
  return {{},
          fmt::format("{} hold channels of the same names: whether these are "
                      "several runs or several sensors cannot be told",
                      quoted_keys(parts))};
}

// Arrays as long as records are, of which none became one.
std::vector<std::string> name_left_out(const Arrays& all,
                                       const std::vector<FileRun>& runs) {
  std::set<std::string> used;
  std::set<Index> lengths;
  for (const FileRun& run : runs) {
    for (const TimeRecord& record : run.records) {
      used.insert(record.column);
      used.insert(array_of(record));
      lengths.insert(record.values.size());
    }
  }
  std::vector<std::string> left_out;
  if (lengths.empty()) return left_out;
  for (const NamedArray& array : all) {
    if (used.contains(array.name) || 10 * array.samples() < *lengths.begin() ||
        !is_record_array(all, array)) {
      continue;
    }
    left_out.push_back(
        lengths.contains(array.samples())
            ? fmt::format("\"{}\" is left out: not every run has it",
                          array.name)
            : fmt::format("\"{}\" is left out: it holds {} samples, the "
                          "other channels {}",
                          array.name,
                          array.samples(),
                          fmt::join(lengths, " or ")));
  }
  return left_out;
}

// What parts to try, the surest first.
std::vector<std::vector<Part>> possible_parts(
    const Arrays& all, const std::vector<TimeRecord>& flat) {
  if (is_testlab(all)) return {parts_by_repetition(flat)};
  if (is_rattlesnake(all)) return {};
  std::vector<std::vector<Part>> possible;
  for (const KeyOf key_of : run_keys()) {
    possible.push_back(parts_by_name(all, key_of));
  }
  possible.push_back(parts_by_column(flat));
  return possible;
}

}  // namespace

FileRuns runs_of_arrays(const Arrays& all) {
  FileRuns result;
  std::vector<TimeRecord> flat = records_of_arrays(all);
  for (std::vector<Part>& parts : possible_parts(all, flat)) {
    if (parts.size() < 2) continue;
    Judgement judged = judge(std::move(parts), flat);
    if (!judged.runs.empty()) {
      result.runs = std::move(judged.runs);
      result.doubt.clear();
      break;
    }
    if (result.doubt.empty()) result.doubt = std::move(judged.doubt);
  }
  if (result.runs.empty()) result.runs.push_back({"", std::move(flat)});
  if (!is_testlab(all) && !is_rattlesnake(all)) {
    result.left_out = name_left_out(all, result.runs);
  }
  return result;
}

}  // namespace tapfit::acquisition

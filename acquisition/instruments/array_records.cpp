#include "acquisition/instruments/array_records.hpp"

#include "acquisition/foundation/utf8.hpp"
#include "acquisition/instruments/known_layouts.hpp"
#include "acquisition/instruments/point_names.hpp"
#include "acquisition/instruments/sampling.hpp"
#include "acquisition/instruments/usual_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Arrays = std::vector<NamedArray>;
using Kind = NamedArray::Kind;

// A length of netCDF4 stands in the file as an empty dataset.
bool is_dimension(const Arrays& all, const NamedArray& array) {
  const NamedArray* name = find_array(all, array.name + "@NAME");
  return name != nullptr && name->texts.size() == 1 &&
         name->texts[0].starts_with("This is a netCDF dimension");
}

bool may_be_record(const Arrays& all, const NamedArray& array) {
  if (array.kind != Kind::Numbers || array.samples() < 2 ||
      array.columns() < 1 || array.name.find('@') != std::string::npos ||
      is_dimension(all, array)) {
    return false;
  }
  const UsualName is = usual_name(array.name);
  return is == UsualName::None || is == UsualName::Names ||
         is == UsualName::Units;
}

Index longest(const Arrays& all) {
  Index samples = 0;
  for (const NamedArray& array : all) {
    if (array.samples() <= samples || !is_record_array(all, array)) continue;
    samples = array.samples();
  }
  return samples;
}

// A name that belongs to the file, where several arrays may be channels.
bool is_of_file(const Arrays& all,
                const NamedArray& text,
                const NamedArray& array) {
  return text.texts.size() == 1 &&
         text.name.find_first_of("/.:@") == std::string::npos &&
         std::ranges::any_of(all, [&](const NamedArray& other) {
           return &other != &array && other.samples() == array.samples() &&
                  may_be_record(all, other);
         });
}

// A list of texts of some kind: the array's own attribute, else one with as
// many entries as it has columns, the nearest.
std::vector<std::string> texts_beside(const Arrays& all,
                                      const NamedArray& array,
                                      UsualName kind) {
  const NamedArray* found = nullptr;
  std::size_t shared = 0;
  for (const NamedArray& text : all) {
    if (text.kind != Kind::Text || usual_name(text.name) != kind) continue;
    const auto count = static_cast<Index>(text.texts.size());
    const std::size_t at = text.name.find('@');
    if (at != std::string::npos && text.name.substr(0, at) == array.name) {
      if (count == 1 || count == array.columns()) return text.texts;
    }
    if (at != std::string::npos || count != array.columns()) continue;
    const auto alike = static_cast<std::size_t>(
        std::ranges::mismatch(text.name, array.name).in1 - text.name.begin());
    if (found != nullptr && alike <= shared) continue;
    if (kind == UsualName::Names && is_of_file(all, text, array)) continue;
    found = &text;
    shared = alike;
  }
  return found == nullptr ? std::vector<std::string>() : found->texts;
}

// Dewesoft puts "Data1_" in front of each channel.
std::string without_block(const std::string& name) {
  constexpr std::string_view block = "Data";
  if (!name.starts_with(block)) return name;
  std::size_t at = block.size();
  while (at < name.size() &&
         std::isdigit(static_cast<unsigned char>(name[at])) != 0) {
    ++at;
  }
  const bool fits =
      at > block.size() && at + 1 < name.size() && name[at] == '_';
  return fits ? name.substr(at + 1) : name;
}

// The last part of the array's path.
std::string short_name(const std::string& name) {
  std::size_t at = name.rfind('/');
  if (at == std::string::npos) at = name.rfind('.');
  const bool fits = at != std::string::npos && at + 1 < name.size();
  return without_block(fits ? name.substr(at + 1) : name);
}

// As netCDF packs numbers: value = scale_factor stored + add_offset.
double attribute(const Arrays& all,
                 const NamedArray& array,
                 const char* name,
                 double otherwise) {
  const NamedArray* found = find_array(all, array.name + "@" + name);
  const bool fits = found != nullptr && found->kind == Kind::Numbers &&
                    found->values.size() == 1;
  return fits ? found->values(0, 0) : otherwise;
}

// Times in the first column, as people save them.
std::optional<Sampling> by_first_column(const NamedArray& array) {
  const NamedArray times{"first", Kind::Numbers, array.column(0), {}};
  if (array.columns() == 1 || !is_axis(array.column(0))) return std::nullopt;
  return sampling_of({times}, array.name, array.samples());
}

// What the file says of all columns of an array.
struct Beside {
  std::vector<std::string> names;
  std::vector<std::string> units;
  std::optional<Sampling> sampling;

  Beside(const Arrays& all, const NamedArray& array)
      : names(texts_beside(all, array, UsualName::Names)),
        units(texts_beside(all, array, UsualName::Units)),
        sampling(sampling_of(all, array.name, array.samples())) {
    if (!sampling) sampling = by_first_column(array);
    // One name for all columns tells them not apart.
    if (names.size() == 1 && array.columns() > 1) names.clear();
  }

  void describe(std::size_t column, TimeRecord& record) const {
    if (column < names.size()) record.name = names[column];
    if (!units.empty()) record.unit = units[std::min(column, units.size() - 1)];
    if (!sampling) return;
    record.rate_hz = sampling->hz;
    record.rate_spread = sampling->spread;
  }
};

void add_records(const Arrays& all,
                 const NamedArray& array,
                 std::vector<TimeRecord>& records) {
  const Beside beside(all, array);
  const double factor = attribute(all, array, "scale_factor", 1.0);
  const double offset = attribute(all, array, "add_offset", 0.0);
  for (Index k = 0; k < array.columns(); ++k) {
    TimeRecord record;
    record.column = array.columns() == 1
                        ? array.name
                        : fmt::format("{}:{}", array.name, k + 1);
    record.values = (factor * array.column(k)).array() + offset;
    if (is_axis(record.values)) continue;
    beside.describe(static_cast<std::size_t>(k), record);
    if (record.name.empty()) record.name = short_name(record.column);
    records.push_back(std::move(record));
  }
}

// Lists of texts with one entry for each of several arrays, in their order.
void name_in_order(const Arrays& all, std::vector<TimeRecord>& records) {
  for (const NamedArray& text : all) {
    const UsualName is = usual_name(text.name);
    if (text.kind != Kind::Text || records.size() < 2 ||
        text.texts.size() != records.size()) {
      continue;
    }
    for (std::size_t k = 0; k < records.size(); ++k) {
      if (is == UsualName::Names) records[k].name = text.texts[k];
      if (is == UsualName::Units) records[k].unit = text.texts[k];
    }
  }
}

std::vector<TimeRecord> plain_records(const Arrays& all) {
  const Index samples = longest(all);
  std::vector<TimeRecord> records;
  bool single = true;
  for (const NamedArray& array : all) {
    if (!may_be_record(all, array) || array.samples() != samples) continue;
    single = single && array.columns() == 1;
    add_records(all, array, records);
  }
  if (single) name_in_order(all, records);
  return records;
}

void finish(std::vector<TimeRecord>& records) {
  std::set<std::string> used;
  for (TimeRecord& record : records) {
    if (record.name.empty()) record.name = record.column;
    record.name = printable(record.name);
    record.unit = printable(record.unit);
    const std::string name = record.name;
    for (int k = 2; !used.insert(record.name).second; ++k) {
      record.name = fmt::format("{} {}", name, k);
    }
    if (!record.dof) record.dof = point_in_name(record.name);
    if (record.unit == "mV") {
      record.values *= 1e-3;
      record.unit = "V";
    }
  }
}

}  // namespace

bool is_record_array(const Arrays& all, const NamedArray& array) {
  return may_be_record(all, array) &&
         !(array.columns() == 1 && is_axis(array.column(0)));
}

std::vector<TimeRecord> records_of_arrays(const Arrays& all) {
  std::vector<TimeRecord> records;
  if (is_testlab(all)) {
    records = testlab_records(all);
  } else if (is_rattlesnake(all)) {
    records = rattlesnake_records(all);
  } else {
    records = plain_records(all);
  }
  finish(records);
  return records;
}

}  // namespace tapfit::acquisition

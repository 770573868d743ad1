#include "acquisition/bundle/uff_bundle.hpp"

#include "acquisition/bundle/uff_points.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/uff/uff_function.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/uff_units.hpp"
#include "acquisition/uff/uff_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace tapfit::acquisition {
namespace {

constexpr int time_record = 1;
constexpr int frf = 4;

// What a time record is, without its samples.
struct Record {
  std::size_t dataset = 0;
  Quantity quantity = Quantity::Acceleration;
  Dof dof;
  std::string unit;
  double unit_to_si = 1.0;
  double step = 0.0;
  Eigen::Index count = 0;
  std::optional<double> full_scale;  ///< [SI], where an ID line says one
  /// A force in an unknown unit. The motions beside it are no other force's.
  bool lost = false;

  [[nodiscard]] bool force() const { return quantity == Quantity::Force; }
};

std::optional<Quantity> quantity_of(const UffAxis& axis,
                                    const std::optional<Unit>& unit) {
  switch (axis.type) {
    case 8:
      return Quantity::Displacement;
    case 9:
    case 13:
      return Quantity::Force;
    case 11:
      return Quantity::Velocity;
    case 12:
      return Quantity::Acceleration;
    default:
      break;
  }
  if (axis.type > 1 || !unit) return std::nullopt;
  return unit->quantity;
}

// The record, or why it is none that can be used; of a lost force both.
std::optional<Record> record_of(const UffHeader& header,
                                const UffMesh& mesh,
                                const UffUnits& units,
                                std::string& reason) {
  const std::optional<Unit> unit = find_unit(header.numerator.unit);
  const auto quantity = quantity_of(header.numerator, unit);
  if (!quantity) {
    reason = fmt::format("\"{}\" (data type {}) is no force or motion",
                         header.numerator.unit,
                         header.numerator.type);
  } else if (!header.response) {
    reason = "it says no direction";
  } else if (header.response->component > 3) {
    reason = "it is a rotation";
  } else if (!header.even || !(header.step > 0.0) || header.count < 2) {
    reason = "its sampling is uneven";
  } else if (header.complex) {
    reason = "its values are complex";
  }
  if (!reason.empty()) return std::nullopt;
  const auto to_si = uff_unit_to_si(header.numerator.unit, *quantity, units);
  Record record;
  record.quantity = *quantity;
  if (!to_si) {
    reason = no_uff_unit(header.numerator.unit, *quantity);
    record.lost = record.force();
    if (!record.lost) return std::nullopt;
  }
  record.dof = turned(mesh.geometry, *header.response);
  record.unit = unit ? header.numerator.unit : "";
  record.unit_to_si = to_si.value_or(1.0);
  record.step = header.step;
  record.count = header.count;
  record.full_scale = number_in_id(header.id, "FULL SCALE =");
  return record;
}

std::optional<std::array<double, 2>> band_in(const UffHeader& header) {
  const auto low = number_in_id(header.id, "BAND =");
  const auto high = number_in_id(header.id, "TO =");
  if (!low || !high || !(*low > 0.0) || !(*high > *low)) return std::nullopt;
  return std::array{*low, *high};
}

// What the file holds, as far as a bundle needs it.
struct Contents {
  std::vector<Record> records;
  std::string title;
  std::optional<std::array<double, 2>> band_hz;  ///< of an ID line
  bool frfs = false;
  std::vector<std::string> skipped;
  std::vector<TestPoint> points;
};

Contents contents_of(const UffFile& file) {
  Contents found;
  const UffMesh mesh = read_uff_mesh(file.datasets);
  found.points = own_points(mesh, file.name);
  UffUnits units;
  for (std::size_t k = 0; k < file.datasets.size(); ++k) {
    const UffDataset& dataset = file.datasets[k];
    if (dataset.type == 164) units = read_uff_units(dataset);
    if (dataset.type == 151 && !dataset.lines.empty()) {
      found.title = printable(column(dataset.lines[0], 0, 80));
    }
    if (dataset.type != 58) continue;
    const int type = function_type(dataset);
    found.frfs = found.frfs || type == frf;
    if (type != time_record) continue;
    std::string reason;
    const UffHeader header = read_header(dataset);
    if (!found.band_hz) found.band_hz = band_in(header);
    if (auto record = record_of(header, mesh, units, reason)) {
      record->dataset = k;
      found.records.push_back(*record);
    }
    if (!reason.empty()) {
      found.skipped.push_back(fmt::format(
          "{}: a time record is left out: {}", dataset.place, reason));
    }
  }
  return found;
}

using Group = std::vector<Record>;

// Whether a record cannot belong to the run that the group has become.
bool begins_run(const Group& group, const Record& record) {
  if (group.empty()) return false;
  const bool same_sampling =
      group[0].count == record.count &&
      std::abs(group[0].step - record.step) <= 1e-6 * record.step;
  return !same_sampling ||
         std::any_of(group.begin(), group.end(), [&](const Record& other) {
           return record.force() ? other.force()
                                 : !other.force() && other.dof == record.dof;
         });
}

bool is_run(const Group& group) {
  const auto forces = std::ranges::count_if(group, &Record::force);
  const bool lost = std::ranges::any_of(group, &Record::lost);
  return forces == 1 && group.size() > 1 && !lost;
}

std::vector<Group> groups_of(const std::vector<Record>& records) {
  std::vector<Group> groups;
  for (const Record& record : records) {
    if (groups.empty() || begins_run(groups.back(), record)) {
      groups.emplace_back();
    }
    groups.back().push_back(record);
  }
  return groups;
}

Channel channel_of(const Record& record, std::size_t number) {
  constexpr std::array<const char*, 4> plain{"N", "m/s^2", "m/s", "m"};
  constexpr std::array<const char*, 4> names{"hammer", "acc", "vel", "disp"};
  const auto kind = static_cast<std::size_t>(record.quantity);
  Channel channel;
  channel.name = names.at(kind) +
                 (record.force() ? std::string() : fmt::format("{}", number));
  channel.quantity = record.quantity;
  channel.unit = record.unit.empty() ? plain.at(kind) : record.unit;
  channel.unit_to_si = record.unit_to_si;
  // A sensitivity of 1: volts are the channel's own unit.
  channel.full_scale_volts = record.full_scale
                                 ? *record.full_scale / record.unit_to_si
                                 : std::numeric_limits<double>::infinity();
  return channel;
}

// Adds a run, with the channels that it needs and no run had before.
void add_run(const Group& group, TestBundle& bundle) {
  Run run;
  run.file = *bundle.uff;
  std::set<std::size_t> used;
  for (const Record& record : group) {
    std::size_t c = 0;
    while (
        c < bundle.channels.size() &&
        (bundle.channels[c].quantity != record.quantity || used.contains(c))) {
      ++c;
    }
    if (c == bundle.channels.size()) {
      bundle.channels.push_back(channel_of(record, c));
    }
    used.insert(c);
    run.datasets.push_back({c, record.dataset, record.unit_to_si});
    if (record.force()) {
      run.hammer = {c, record.dof};
    } else {
      run.sensors.push_back({c, record.dof});
    }
  }
  bundle.runs.push_back(std::move(run));
}

void refuse_empty(const TestBundle& bundle, const UffFile& file) {
  if (!bundle.runs.empty() || bundle.frfs) return;
  const bool modes = std::ranges::any_of(file.datasets, [](const auto& d) {
    return d.type == 55 || d.type == 2414;
  });
  if (modes) {
    throw InputError(
        "the universal file holds results at nodes, such as modes, and no "
        "records",
        file.name,
        fmt::format("write {{\"tapfit\": 1, \"modes\": \"{}\"}} as test.json "
                    "beside it, with \"model\" where there is a deck, and open "
                    "its folder",
                    bundle.file.filename().string()));
  }
  std::string what =
      "the universal file holds neither a force record with motions beside it "
      "nor an FRF";
  for (const std::string& line : bundle.warnings) {
    if (what.size() > 400) break;
    what += "; " + line;
  }
  throw InputError(what,
                   file.name,
                   "export time records of hammer and sensors with their "
                   "points (dataset 58, function type 1), or FRFs (type 4)");
}

}  // namespace

TestBundle read_uff_bundle(const std::filesystem::path& path) {
  const UffFile file = open_uff(path);
  const Contents found =
      file.bytes.reading([&file] { return contents_of(file); });
  TestBundle bundle;
  bundle.folder = path.parent_path();
  bundle.file = path;
  bundle.title = found.title.empty() ? path.stem().string() : found.title;
  bundle.uff = path;
  bundle.band_hz = found.band_hz;
  bundle.warnings = found.skipped;
  bundle.points = found.points;
  for (const Group& group : groups_of(found.records)) {
    if (is_run(group)) {
      add_run(group, bundle);
      continue;
    }
    bundle.warnings.push_back(fmt::format(
        "{}: {} time records from here on are left out: a run needs one force "
        "and at least one motion",
        file.datasets[group[0].dataset].place,
        group.size()));
  }
  if (bundle.runs.empty() && found.frfs) bundle.frfs = path;
  refuse_empty(bundle, file);
  return bundle;
}

double whole_rate_of(double step) {
  const double rate = 1.0 / step;
  const double whole = std::round(rate);
  return std::abs(rate - whole) <= 5e-6 * rate ? whole : rate;
}

double rate_of(const UffHeader& header) {
  const double rate = whole_rate_of(header.step);
  const auto said = number_in_id(header.id, "RATE =");
  // Unless record 7 was changed and the line was not.
  return said && std::abs(*said * header.step - 1.0) <= 1e-5 ? *said : rate;
}

namespace {

Recording read_run_now(const UffFile& file,
                       const Run& run,
                       std::size_t channels) {
  Recording recording;
  for (const UffSource& source : run.datasets) {
    const UffDataset& dataset = dataset_of(file, source.dataset);
    const UffHeader header = read_header(dataset);
    if (recording.samples.size() == 0) {
      recording.sample_rate_hz = rate_of(header);
      recording.samples = room_for(
          header.count, static_cast<Eigen::Index>(channels), file.name);
      if (run.datasets.size() < channels) recording.samples.setZero();
    }
    auto column =
        recording.samples.col(static_cast<Eigen::Index>(source.channel));
    UffValues values(dataset, header);
    // In pieces, so that the file's pages do not add to the samples.
    constexpr Eigen::Index at_once = 1 << 20;
    for (Eigen::Index i = 0; i < column.size(); i += at_once) {
      values.read(column.segment(i, std::min(at_once, column.size() - i)));
      file.bytes.forget(values.passed());
    }
    if (source.unit_to_si != 1.0) column *= source.unit_to_si;
  }
  return recording;
}

}  // namespace

Recording read_uff_run(const UffFile& file,
                       const Run& run,
                       std::size_t channels) {
  return file.bytes.reading([&] { return read_run_now(file, run, channels); });
}

}  // namespace tapfit::acquisition

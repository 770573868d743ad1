#include "acquisition/import/propose_import.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/import/channel_points.hpp"
#include "acquisition/import/hammer_channel.hpp"
#include "acquisition/import/import_tables.hpp"
#include "acquisition/import/read_time_records.hpp"
#include "acquisition/import/read_time_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace tapfit::acquisition {
namespace {

using Records = std::vector<const TimeRecord*>;

enum class UnitKind { Known, Volts, None, Other };

UnitKind kind_of(const TimeRecord& record) {
  constexpr auto volts = std::to_array<std::string_view>(
      {"V", "v", "volt", "volts", "Volt", "Volts"});
  constexpr auto none = std::to_array<std::string_view>(
      {"", "-", "1", "none", "None", "NONE", "n/a", "EU", "eu", "?"});
  const std::string_view unit = record.unit;
  if (std::ranges::count(none, unit) > 0) return UnitKind::None;
  if (std::ranges::count(volts, unit) > 0) return UnitKind::Volts;
  return find_unit(unit) ? UnitKind::Known : UnitKind::Other;
}

bool is_force(const TimeRecord& record) {
  const std::optional<Unit> unit = find_unit(record.unit);
  return unit && unit->quantity == Quantity::Force;
}

// Several hammers are several runs, which a universal file is by itself.
void refuse_runs(const InstrumentFile& file) {
  if (!is_uff(file.file) || std::ranges::count_if(file.records, is_force) < 2) {
    return;
  }
  throw InputError("has several records of a force and is a bundle by itself",
                   file.file.string(),
                   "open it as it is: tapfit run FILE");
}

class Proposal {
 public:
  Proposal(const ImportOptions& given, const Progress& progress)
      : file_(read_time_records(given.files.at(0).file, given.csv, progress)) {
    refuse_runs(file_);
    result_.options = given;
  }

  ImportProposal make() {
    propose_runs();
    if (result_.options.hammer.column.empty()) propose_hammer();
    if (result_.options.sensors.empty()) propose_sensors();
    place_channels();
    propose_rate();
    propose_block();
    return std::move(result_);
  }

 private:
  void assume(const std::string& what,
              const std::string& option,
              const std::string& field = "") {
    result_.assumptions.push_back({what, option, field});
  }

  // Where channels are named, the user has chosen.
  void propose_runs() {
    const ImportOptions& options = result_.options;
    if (!options.hammer.column.empty() && !options.sensors.empty()) return;
    const TimeRecord& record = file_.records[0];
    if (!file_.doubt.empty()) {
      throw InputError(
          file_.doubt,
          file_.file.string(),
          "name hammer and sensors of one recording with --hammer "
          "COLUMN@POINT and --sensor COLUMN@POINT, COLUMN such as " +
              record.column);
    }
    if (file_.run_names.empty()) return;
    std::vector<std::string> runs;
    for (std::size_t k = 0; k < file_.run_names.size(); ++k) {
      runs.push_back(fmt::format("\"{}\" ({} samples)",
                                 file_.run_names[k],
                                 records_of(file_, k).at(0).values.size()));
    }
    assume(fmt::format("channels of the same names are recorded again: taken "
                       "as {} runs, {}",
                       runs.size(),
                       fmt::join(runs, ", ")),
           fmt::format("COLUMN in full, such as {}, for one run alone",
                       record.column));
  }

  void propose_hammer() {
    Records channels;
    for (const TimeRecord& record : file_.records) {
      const bool fits = kind_of(record) != UnitKind::Other;
      if (fits && !is_given_sensor(record)) channels.push_back(&record);
    }
    if (channels.empty()) refuse();
    const HammerChoice choice = choose_hammer(channels);
    const TimeRecord& record = *channels[choice.channel];
    if (find_unit(record.unit) && !is_force(record)) refuse();
    const std::string said =
        fmt::format("the hammer is \"{}\", by {}", record.name, choice.reason);
    if (choice.certain) {
      result_.found.push_back(said);
    } else {
      assume(said, "--hammer COLUMN@POINT");
    }
    result_.options.hammer = channel_of(record, Quantity::Force, 0);
  }

  [[nodiscard]] bool is_given_sensor(const TimeRecord& record) const {
    return std::ranges::any_of(result_.options.sensors,
                               [&](const ImportChannel& sensor) {
                                 return record_of(sensor.column) == &record;
                               });
  }

  // Channels in units of motion or without a unit; those in volts where there
  // are no others. The rest is named.
  void propose_sensors() {
    const TimeRecord* hammer = record_of(result_.options.hammer.column);
    const auto of_kind = [&](UnitKind kind) {
      return std::ranges::any_of(file_.records, [&](const TimeRecord& record) {
        return &record != hammer && kind_of(record) == kind &&
               !is_force(record);
      });
    };
    const bool volts = !of_kind(UnitKind::Known) && !of_kind(UnitKind::None);
    for (const TimeRecord& record : file_.records) {
      if (&record == hammer) continue;
      const UnitKind kind = kind_of(record);
      const bool fits = kind == UnitKind::Known || kind == UnitKind::None ||
                        (volts && kind == UnitKind::Volts);
      if (is_force(record)) {
        leave_out(record, "a run has one hammer", "--hammer");
      } else if (!fits) {
        leave_out(record, "that is no unit of motion", "--sensor");
      } else {
        add_sensor(record);
      }
    }
    if (result_.options.sensors.empty()) refuse();
  }

  void leave_out(const TimeRecord& record,
                 const std::string& why,
                 const std::string& option) {
    assume(fmt::format(
               "\"{}\" in {} is left out: {}", record.name, record.unit, why),
           fmt::format("{} {}@POINT", option, record.column));
  }

  void add_sensor(const TimeRecord& record) {
    const std::optional<Unit> unit = find_unit(record.unit);
    const std::size_t place = result_.options.sensors.size() + 1;
    result_.options.sensors.push_back(channel_of(
        record, unit ? unit->quantity : Quantity::Acceleration, place));
  }

  [[noreturn]] void refuse() const {
    std::vector<std::string> names;
    for (const TimeRecord& record : file_.records) {
      names.push_back(fmt::format("\"{}\"", record.name));
    }
    std::string holds =
        fmt::format("holds no hammer with sensors beside it, but {}",
                    fmt::join(names, ", "));
    for (const std::string& what : file_.left_out) holds += "; " + what;
    throw InputError(
        holds,
        file_.file.string(),
        "say which is which with --hammer COLUMN@POINT and --sensor "
        "COLUMN@POINT");
  }

  // @param place of the channel in test.json
  ImportChannel channel_of(const TimeRecord& record,
                           Quantity quantity,
                           std::size_t place) {
    ImportChannel channel;
    channel.column = file_.run_names.empty() ? record.column : record.name;
    channel.channel = record.name;
    channel.quantity = quantity;
    channel.recorded_volts_per_unit = record.volts_per_unit;
    const UnitKind kind = kind_of(record);
    // Where no unit is set, the import takes that of the files, or the usual
    // one, and sees to it that all files have the same.
    if (kind == UnitKind::Known) return channel;
    const std::string option = place == 0 ? "--hammer" : "--sensor";
    const std::string usual = quantity == Quantity::Force ? "N" : "m/s^2";
    if (!record.unit.empty()) channel.unit = usual;
    if (kind == UnitKind::Volts) {
      channel.volts_per_unit = 1.0;
      assume(fmt::format("\"{}\" is in volts; its sensitivity is taken as 1 V "
                         "for each {}",
                         record.name,
                         usual),
             option + " COLUMN@POINT,unit=UNIT,volts_per_unit=NUMBER",
             fmt::format("channels[{}].sensitivity", place));
    } else {
      assume(fmt::format("\"{}\" has no unit; {} is taken", record.name, usual),
             option + " COLUMN@POINT,unit=UNIT",
             fmt::format("channels[{}].unit", place));
    }
    return channel;
  }

  [[nodiscard]] const TimeRecord* record_of(const std::string& column) const {
    return find_record(file_.records, column);
  }

  // The channels that were not given with a point; blows of all files may be.
  [[nodiscard]] std::vector<ImportChannel*> without_point() {
    ImportOptions& options = result_.options;
    const bool all_blows = std::ranges::all_of(
        options.files,
        [](const ImportFile& f) { return f.hammer.has_value(); });
    if (all_blows) options.hammer.dof = *options.files[0].hammer;
    std::vector<ImportChannel*> channels;
    for (ImportChannel& sensor : options.sensors) channels.push_back(&sensor);
    channels.push_back(&options.hammer);
    std::erase_if(channels, [&](const ImportChannel* channel) {
      return channel->dof.node != 0 || record_of(channel->column) == nullptr;
    });
    return channels;
  }

  void place_channels() {
    const std::vector<ImportChannel*> channels = without_point();
    Records records;
    for (const ImportChannel* channel : channels) {
      records.push_back(record_of(channel->column));
    }
    int taken = result_.options.hammer.dof.node;
    for (const ImportChannel& sensor : result_.options.sensors) {
      taken = std::max(taken, sensor.dof.node);
    }
    const std::vector<Dof> points = points_for(records);
    std::vector<std::string> assumed;
    for (std::size_t k = 0; k < channels.size(); ++k) {
      Dof& dof = channels[k]->dof;
      dof = points[k];
      if (records[k]->dof) continue;
      dof.node += taken;
      assumed.push_back(
          fmt::format("\"{}\" {}", channels[k]->channel, name(dof)));
    }
    name_shared_points();
    if (assumed.empty()) return;
    assume(
        fmt::format("points are not in the file; taken are {}",
                    fmt::join(assumed, ", ")),
        "--hammer and --sensor COLUMN@POINT, FILE@POINT for each file's blows",
        "runs[].hammer and runs[].sensors[]: node, direction");
  }

  // Two columns of one name, or names that hold one point.
  void name_shared_points() {
    const std::vector<ImportChannel>& sensors = result_.options.sensors;
    for (std::size_t k = 0; k < sensors.size(); ++k) {
      for (std::size_t i = 0; i < k; ++i) {
        if (sensors[i].dof.node != sensors[k].dof.node ||
            sensors[i].dof.component != sensors[k].dof.component ||
            sensors[i].quantity != sensors[k].quantity) {
          continue;
        }
        assume(fmt::format("\"{}\" and \"{}\" are both at {}",
                           sensors[i].channel,
                           sensors[k].channel,
                           name(sensors[k].dof)),
               "--sensor COLUMN@POINT for each that is meant",
               fmt::format("runs[].sensors[{}]: node, direction", k));
      }
    }
  }

  void propose_rate() {
    const TimeRecord* record = record_of(result_.options.hammer.column);
    ImportOptions& options = result_.options;
    if (options.sample_rate_hz || options.rate_variable ||
        options.time_column || record == nullptr) {
      return;
    }
    if (!file_.time_column.empty()) {
      options.time_column = file_.time_column;
    }
    if (record->rate_hz) {
      result_.found.push_back(
          fmt::format("sampled at {:.8g} Hz", *record->rate_hz));
    } else if (!options.time_column) {
      refuse_without_rate(file_.file);
    }
  }

  void propose_block() {
    const TimeRecord* record = record_of(result_.options.hammer.column);
    const std::optional<double> rate =
        result_.options.sample_rate_hz || record == nullptr
            ? result_.options.sample_rate_hz
            : record->rate_hz;
    if (file_.frame == 0 || !rate) return;
    result_.options.block_s = static_cast<double>(file_.frame) / *rate;
    assume(
        fmt::format("the record is frames of {:.6g} s end to end; blocks are "
                    "as long",
                    *result_.options.block_s),
        "",
        "block_s");
  }

  InstrumentFile file_;
  ImportProposal result_;
};

}  // namespace

ImportProposal propose_import(const ImportOptions& given,
                              const Progress& progress) {
  if (given.files.empty()) return {given, {}, {}};
  check_import(given);
  return Proposal(given, progress).make();
}

}  // namespace tapfit::acquisition

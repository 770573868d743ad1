#include "modal/mode_set/read_modes_csv.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/csv_table.hpp"
#include "modal/mode_set/complexity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::modal {
namespace {

using acquisition::CsvHeader;
using Eigen::Index;

/// A column, and the sign of the direction that it names.
struct PointColumn {
  Index at = 0;
  double sign = 1.0;
};

/// Columns of the table that one point has.
struct PointColumns {
  std::optional<PointColumn> real;
  std::optional<PointColumn> imaginary;
  std::optional<PointColumn> sd;
};

/// Where the names of columns stand, for messages.
std::string header_place(const CsvHeader& header,
                         const std::filesystem::path& file) {
  return fmt::format("{}:{}", file.string(), header.line);
}

struct Columns {
  std::vector<std::string> names;  ///< of those that are read
  std::map<std::string, Index> own;
  std::map<Dof, PointColumns> points;  ///< of sign +1
  std::vector<std::string> unread;
};

/// "12Z+ sd" to 12Z+ and "sd".
std::optional<std::pair<Dof, std::string>> point_column(
    const std::string& name) {
  for (const char* part : {" re", " im", " sd"}) {
    if (!name.ends_with(part)) continue;
    const std::optional<Dof> dof = parse_dof(name.substr(0, name.size() - 3));
    if (dof) return std::pair{*dof, std::string(part + 1)};
  }
  const std::optional<Dof> dof = parse_dof(name);
  if (!dof) return std::nullopt;
  return std::pair{*dof, std::string("re")};
}

[[noreturn]] void refuse_second(const std::string& column,
                                const std::string& place) {
  throw InputError(
      fmt::format("the column \"{}\" says again what one before it says",
                  column),
      place,
      "leave one of the two out");
}

/// "Frequency [Hz]" to "frequency_hz", "Damping (%)" to "damping_percent": as
/// instruments write them; other names as they are.
std::string usual_column(const std::string& name) {
  static const std::map<std::string, std::string> usual{
      {"frequencyhz", "frequency_hz"},
      {"freqhz", "frequency_hz"},
      {"fhz", "frequency_hz"},
      {"frequency", "frequency_hz"},
      {"dampingratio", "damping_ratio"},
      {"damping%", "damping_percent"},
      {"dampingratio%", "damping_percent"},
      {"zeta%", "damping_percent"},
      {"dampingpercent", "damping_percent"}};
  std::string plain;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '%') {
      plain += static_cast<char>(std::tolower(letter));
    }
  }
  const auto found = usual.find(plain);
  return found == usual.end() ? name : found->second;
}

/// A name with the unit of a line below it: "Damping" and "%" to
/// "damping_percent". A ratio has none, and names that say their unit need no
/// second one.
std::string own_column(const std::string& name, std::string unit) {
  if (unit == "-" || unit == "1") unit = "ratio";
  const std::string own = usual_column(name);
  const bool repeated = (unit == "Hz" && own.ends_with("_hz")) ||
                        (unit == "%" && own.ends_with("_percent")) ||
                        (unit == "ratio" && own == "damping_ratio");
  return unit.empty() || repeated ? own : usual_column(name + " " + unit);
}

Columns columns_of(const CsvHeader& header, const std::string& place) {
  static const std::vector<std::string> known{"frequency_hz",
                                              "frequency_sd_hz",
                                              "frequency_sd_percent",
                                              "damping_ratio",
                                              "damping_percent",
                                              "damping_sd",
                                              "damping_sd_percent"};
  Columns columns;
  for (std::size_t k = 0; k < header.names.size(); ++k) {
    const std::string& name = header.names[k];
    const auto at = static_cast<Index>(columns.names.size());
    const std::string own =
        own_column(name, k < header.units.size() ? header.units[k] : "");
    if (std::ranges::count(known, own) > 0) {
      if (!columns.own.emplace(own, at).second) refuse_second(name, place);
    } else if (auto point = point_column(name)) {
      auto& [dof, part] = *point;
      const double sign = dof.sign;
      dof.sign = 1;
      PointColumns& of = columns.points[dof];
      std::optional<PointColumn>& column = part == "im"   ? of.imaginary
                                           : part == "sd" ? of.sd
                                                          : of.real;
      if (column) refuse_second(name, place);
      column = {at, sign};
    } else {
      columns.unread.push_back(name);
      continue;
    }
    columns.names.push_back(name);
  }
  return columns;
}

void check(const Columns& columns, const std::string& place) {
  if (!columns.own.contains("frequency_hz")) {
    throw InputError(
        "there is no column \"frequency_hz\"",
        place,
        "name the columns in the first line: frequency_hz (in Hz), "
        "damping_ratio, and points such as 12Z+");
  }
  for (const auto& [dof, of] : columns.points) {
    if (of.real) continue;
    throw InputError(
        fmt::format("there is no column of values for the point {}", name(dof)),
        place,
        fmt::format("name it \"{}\", or \"{} re\" beside \"{} im\"",
                    name(dof),
                    name(dof),
                    name(dof)));
  }
}

/// One line of the table.
class Line {
 public:
  Line(const Columns& columns, Eigen::RowVectorXd values)
      : columns_(&columns), values_(std::move(values)) {}

  /// The column, or that in percent, or nothing.
  [[nodiscard]] double of(const char* plain, const char* percent) const {
    if (const auto own = find(plain)) return *own;
    return 0.01 * find(percent).value_or(0.0);
  }

  [[nodiscard]] Mode mode() const {
    Mode mode;
    const double hz = *find("frequency_hz");
    set_pole(mode, hz, of("damping_ratio", "damping_percent"));
    mode.damping_sd = of("damping_sd", "damping_sd_percent");
    mode.frequency_sd_hz =
        find("frequency_sd_hz")
            .value_or(0.01 * hz * find("frequency_sd_percent").value_or(0.0));
    const auto points = static_cast<Index>(columns_->points.size());
    mode.shape.resize(points);
    Eigen::VectorXd sd = Eigen::VectorXd::Zero(points);
    Index k = 0;
    for (const auto& [dof, at] : columns_->points) {
      mode.shape(k) = {value(at.real), value(at.imaginary)};
      if (at.sd) sd(k) = values_(at.sd->at);
      ++k;
    }
    if (!sd.isZero(0.0)) mode.shape_sd = sd;
    mode.mpc = phase_collinearity(mode.shape);
    mode.mpd_deg = mean_phase_deviation(mode.shape);
    return mode;
  }

 private:
  [[nodiscard]] double value(const std::optional<PointColumn>& column) const {
    return column ? column->sign * values_(column->at) : 0.0;
  }

  [[nodiscard]] std::optional<double> find(const char* name) const {
    const auto at = columns_->own.find(name);
    if (at == columns_->own.end()) return std::nullopt;
    return values_(at->second);
  }

  const Columns* columns_;
  Eigen::RowVectorXd values_;
};

}  // namespace

ModeSet read_modes_csv(const std::filesystem::path& file) {
  const CsvHeader header = acquisition::read_csv_header(file);
  const std::string place = header_place(header, file);
  const Columns columns = columns_of(header, place);
  check(columns, place);
  if (header.rows == 0) {
    throw InputError("there is no mode below the names of columns",
                     place,
                     "write a line of numbers for each mode");
  }
  acquisition::CsvOptions options;
  options.skip_lines = header.rows_from;
  const Eigen::MatrixXd table =
      acquisition::read_csv_columns(file, columns.names, options);
  ModeSet set;
  for (const auto& [dof, at] : columns.points) set.dofs.push_back(dof);
  for (Index i = 0; i < table.rows(); ++i) {
    set.modes.push_back(Line(columns, table.row(i)).mode());
  }
  std::ranges::stable_sort(set.modes, {}, &Mode::frequency_hz);
  for (const std::string& name : columns.unread) {
    set.warnings.push_back(fmt::format(
        "{}: the column \"{}\" is not read: it names no point such as 12Z+",
        file.filename().string(),
        name));
  }
  return set;
}

}  // namespace tapfit::modal

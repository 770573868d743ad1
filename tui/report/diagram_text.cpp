#include "tui/report/diagram_text.hpp"

#include "modal/poles/cmif.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace tapfit::tui {
namespace {

constexpr int columns = 68;
constexpr int most_rows = 25;
constexpr int most_curves = 3;               // singular values shown
constexpr std::string_view rank = " ofvds";  // steadier to the right

struct FrequencyAxis {
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] std::optional<int> column(double hz) const {
    if (!(hz >= low && hz <= high)) return std::nullopt;
    const double share = (hz - low) / (high - low);
    return std::min(columns - 1, static_cast<int>(share * columns));
  }
};

/// Highest order first; neighbouring orders share a row where there are many.
std::string pole_rows(const modal::ModeSet& modes, const FrequencyAxis& axis) {
  int highest = 1;
  for (const modal::DiagramPole& pole : modes.diagram) {
    highest = std::max(highest, pole.order);
  }
  const int step = (highest + most_rows - 1) / most_rows;
  std::map<int, std::string, std::greater<>> rows;
  for (int row = 0; row * step <= highest; ++row) {
    rows[row] = std::string(columns, ' ');
  }
  for (const modal::DiagramPole& pole : modes.diagram) {
    const std::optional<int> column = axis.column(pole.frequency_hz);
    if (!column) continue;
    char& cell = rows[pole.order / step][static_cast<std::size_t>(*column)];
    if (rank.find(pole.letter) > rank.find(cell)) cell = pole.letter;
  }
  std::string text;
  for (const auto& [number, cells] : rows) {
    const std::size_t end = cells.find_last_not_of(' ');
    text +=
        fmt::format("  {:>4} |{}\n", number * step, cells.substr(0, end + 1));
  }
  return text;
}

/// Bars of eight heights over the 60 dB below `top`.
std::string bars(const Eigen::VectorXd& f,
                 const Eigen::VectorXd& values,
                 double top,
                 const FrequencyAxis& axis) {
  constexpr std::array<const char*, 9> heights{" ",
                                               "\u2581",
                                               "\u2582",
                                               "\u2583",
                                               "\u2584",
                                               "\u2585",
                                               "\u2586",
                                               "\u2587",
                                               "\u2588"};
  std::vector<double> highest(columns, 0.0);
  for (Eigen::Index k = 0; k < f.size(); ++k) {
    const std::optional<int> column = axis.column(f(k));
    if (!column) continue;
    double& cell = highest[static_cast<std::size_t>(*column)];
    cell = std::max(cell, values(k));
  }
  std::string text;
  for (const double value : highest) {
    const double share =
        value > 0.0 ? 1.0 + std::log10(value / top) / 3.0 : 0.0;
    const double height = std::clamp(std::round(8.0 * share), 0.0, 8.0);
    text += heights[static_cast<std::size_t>(height)];
  }
  return text;
}

std::string curve_rows(const signal::FrfSet& frfs, const FrequencyAxis& axis) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  const Eigen::VectorXd sum = modal::summed_frf(frfs);
  const auto top = [&](const Eigen::VectorXd& values) {
    double largest = 1e-300;
    for (Eigen::Index k = 0; k < f.size(); ++k) {
      if (axis.column(f(k))) largest = std::max(largest, values(k));
    }
    return largest;
  };
  std::string text = "   |H| |" + bars(f, sum, top(sum), axis) + "\n";
  const Eigen::MatrixXd cmif = modal::cmif(frfs);
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(most_curves, cmif.cols());
       ++k) {
    text += fmt::format(
        "  CMIF{}|{}\n", k + 1, bars(f, cmif.col(k), top(cmif.col(0)), axis));
  }
  return text;
}

std::string frequency_row(const FrequencyAxis& axis) {
  std::string ticks(columns, '-');
  std::string names(columns + 12, ' ');
  for (int k = 0; k <= 4; ++k) {
    const int column = k * (columns - 1) / 4;
    ticks[static_cast<std::size_t>(column)] = '+';
    const double hz = axis.low + (axis.high - axis.low) * k / 4.0;
    const std::string label = number(hz, 4);
    const int begin = std::max(0, column - static_cast<int>(label.size()) / 2);
    names.replace(static_cast<std::size_t>(begin), label.size(), label);
  }
  names.erase(names.find_last_not_of(' ') + 1);
  return "       +" + ticks + "\n        " + names + " Hz\n";
}

}  // namespace

std::string diagram_text(const modal::ModeSet& modes,
                         const signal::FrfSet& frfs,
                         double low_hz,
                         double high_hz) {
  const FrequencyAxis axis{low_hz, std::max(high_hz, low_hz + 1e-9)};
  std::string taken(columns, ' ');
  for (const modal::Mode& mode : modes.modes) {
    const std::optional<int> column = axis.column(mode.frequency_hz);
    if (column) taken[static_cast<std::size_t>(*column)] = '^';
  }
  taken.erase(taken.find_last_not_of(' ') + 1);
  return "Stabilisation: s stable in all, d damping, v vector, f frequency, "
         "o new\n order\n" +
         pole_rows(modes, axis) + " modes |" + taken + "\n" +
         curve_rows(frfs, axis) + frequency_row(axis);
}

}  // namespace tapfit::tui

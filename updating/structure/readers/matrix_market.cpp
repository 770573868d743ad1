#include "updating/structure/readers/matrix_market.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/readers/output4.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <unordered_map>

namespace tapfit::structure {
namespace {

std::ifstream open(const std::filesystem::path& path,
                   std::uintmax_t most_bytes = UINTMAX_MAX) {
  std::ifstream file = acquisition::open_input(path, most_bytes);
  if (!file) {
    throw InputError("cannot open the file",
                     path.string(),
                     "Check the file's name and that it may be read.");
  }
  return file;
}

// Lines of a Matrix Market file with the place for messages.
class MarketReader {
 public:
  explicit MarketReader(const std::filesystem::path& path)
      : file_(open(path)), name_(path.filename().string()) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(what,
                     fmt::format("{}:{}", name_, line_),
                     "Write a real, symmetric or general Matrix Market file.");
  }

  /// The next line's numbers; comments and blank lines are passed over.
  std::vector<double> numbers(std::size_t count) {
    std::string text;
    while (std::getline(file_, text)) {
      ++line_;
      if (trimmed(text).empty() || text.front() == '%') continue;
      std::istringstream words(text);
      std::vector<double> values;
      std::string word;
      while (words >> word) {
        const std::optional<double> value = parse_real(word);
        if (!value) fail("here is no finite number");
        values.push_back(*value);
      }
      if (values.size() != count) {
        fail(fmt::format(
            "{} numbers where {} are needed", values.size(), count));
      }
      return values;
    }
    fail("the file ends too early");
  }

  /// Throws where numbers follow.
  void end() {
    std::string text;
    while (std::getline(file_, text)) {
      ++line_;
      if (trimmed(text).empty() || text.front() == '%') continue;
      fail("there are more entries than the size line says");
    }
  }

  std::string header() {
    line_ = 1;
    if (file_.peek() != '%') return {};  // a foreign file's line may not end
    std::string text;
    std::getline(file_, text);
    return upper(text);
  }

  Eigen::Index index(double value, double size, const char* what) const {
    if (value != std::floor(value) || value < 1.0 || value > size) {
      fail(fmt::format("{} {} is outside the matrix", what, value));
    }
    return static_cast<Eigen::Index>(value) - 1;
  }

 private:
  std::ifstream file_;
  std::string name_;
  int line_ = 0;
};

using Triplets = std::vector<Eigen::Triplet<double>>;

// An entry that stands twice would count twice; so would both triangles of a
// symmetric matrix.
void check_single(const Triplets& triplets, const std::filesystem::path& path) {
  std::vector<std::pair<int, int>> places;
  places.reserve(triplets.size());
  for (const auto& entry : triplets) {
    places.emplace_back(entry.row(), entry.col());
  }
  std::ranges::sort(places);
  const auto twice = std::ranges::adjacent_find(places);
  if (twice == places.end()) return;
  throw InputError(
      fmt::format("the entry of row {} and column {} is given twice",
                  twice->first + 1,
                  twice->second + 1),
      path.filename().string(),
      "give each entry once, of a symmetric matrix one triangle alone");
}

void add(Eigen::Index i,
         Eigen::Index j,
         double value,
         bool symmetric,
         Triplets& triplets) {
  triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  if (symmetric && i != j) {
    triplets.emplace_back(static_cast<int>(j), static_cast<int>(i), value);
  }
}

struct Row {
  int node = 0;
  int component = 0;
  std::optional<Eigen::Vector3d> position;
  std::string where;  // file and line
};

std::optional<int> component_of(const std::string& text) {
  static constexpr std::array<const char*, 6> names{
      "X", "Y", "Z", "RX", "RY", "RZ"};
  for (int i = 0; i < 6; ++i) {
    if (text == names[static_cast<std::size_t>(i)]) return i + 1;
  }
  const std::optional<int> digit = parse_integer(text);
  if (!digit || *digit < 1 || *digit > 6) return std::nullopt;
  return digit;
}

// Coordinates that the table leaves out are zero, all of them or the last ones
// (a structure in a plane); nothing where it has none.
std::optional<Eigen::Vector3d> parse_position(
    const std::vector<std::string>& cells, bool& good) {
  std::optional<Eigen::Vector3d> position;
  for (std::size_t i = 2; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    const std::optional<double> x = parse_real(cells[i]);
    good = good && x && i < 5;
    if (!good) return std::nullopt;
    if (!position) position = Eigen::Vector3d::Zero();
    (*position)(static_cast<Eigen::Index>(i) - 2) = *x;
  }
  return position;
}

Row parse_row(const std::string& text, const std::string& where) {
  std::vector<std::string> cells;
  std::istringstream line(text);
  for (std::string cell; std::getline(line, cell, ',');) {
    cells.push_back(trimmed(cell));
  }
  cells.resize(std::max<std::size_t>(cells.size(), 2));
  const std::optional<int> node = parse_integer(cells[0]);
  const std::optional<int> component = component_of(upper(cells[1]));
  bool good = node && *node > 0 && component;
  Row row;
  row.position = parse_position(cells, good);
  if (!good) {
    // Of a file that is no such table nothing is quoted.
    const std::string what =
        node ? fmt::format("\"{}\" is", text) : std::string("this line is");
    throw InputError(what + " not a degree of freedom",
                     where,
                     "Write node,component or node,component,x,y,z with "
                     "components 1 to 6 or X, Y, Z, RX, RY, RZ.");
  }
  row.node = *node;
  row.component = *component;
  row.where = where;
  return row;
}

std::vector<Row> read_rows(const std::filesystem::path& path) {
  std::ifstream file = open(path, acquisition::most_text_bytes);
  std::vector<Row> rows;
  std::set<std::array<int, 2>> seen;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    text = trimmed(text);
    if (text.empty() || text.front() == '#') continue;
    if (rows.empty() && line == 1 && !parse_integer(text.substr(0, 1)))
      continue;
    const std::string where =
        fmt::format("{}:{}", path.filename().string(), line);
    rows.push_back(parse_row(text, where));
    if (!seen.insert({rows.back().node, rows.back().component}).second) {
      throw InputError("this degree of freedom is named twice",
                       where,
                       "Each row of the matrices needs its own.");
    }
  }
  return rows;
}

void check_symmetric(const SparseMatrix& A, const std::filesystem::path& path) {
  const SparseMatrix At = A.transpose();
  // Ten digits: what programs that print text keep.
  if ((A - At).norm() > 1e-10 * A.norm()) {
    throw InputError("the matrix is not symmetric",
                     path.filename().string(),
                     "Only symmetric stiffness and mass matrices are used.");
  }
}

SparseMatrix scatter(const SparseMatrix& A,
                     const std::vector<int>& place,
                     Eigen::Index size) {
  Triplets triplets;
  for (int col = 0; col < A.outerSize(); ++col) {
    for (SparseMatrix::InnerIterator it(A, col); it; ++it) {
      triplets.emplace_back(place[static_cast<std::size_t>(it.row())],
                            place[static_cast<std::size_t>(col)],
                            it.value());
    }
  }
  SparseMatrix result(size, size);
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

// Where each node is: its rows say the same, or nothing.
std::unordered_map<int, Eigen::Vector3d> positions(
    const std::vector<Row>& rows) {
  std::unordered_map<int, Eigen::Vector3d> known;
  for (const Row& row : rows) {
    if (!row.position) continue;
    const auto [at, is_new] = known.try_emplace(row.node, *row.position);
    // What programs that print six digits keep.
    const double slack = 1e-5 * row.position->norm();
    if (is_new || (at->second - *row.position).norm() <= slack) continue;
    throw InputError(
        fmt::format("node {} is elsewhere in a line above", row.node),
        row.where,
        "Give the lines of one node the same x, y, z, or all but one none.");
  }
  return known;
}

void check_diagonal(const SparseMatrix& A,
                    const std::vector<Row>& rows,
                    const std::filesystem::path& path) {
  const Eigen::VectorXd diagonal = A.diagonal();
  Eigen::Index least = 0;
  if (diagonal.minCoeff(&least) >= 0.0) return;
  const Row& row = rows[static_cast<std::size_t>(least)];
  throw InputError(
      fmt::format("row {} (node {}, component {}) has {:.6g} on the diagonal: "
                  "its motion would have negative energy",
                  least + 1,
                  row.node,
                  row.component,
                  diagonal(least)),
      path.filename().string(),
      "Check the signs, and which matrix it is.");
}

// Makes the grids and tells where each row goes.
std::vector<int> place_rows(const std::vector<Row>& rows, Deck& deck) {
  const std::unordered_map<int, Eigen::Vector3d> known = positions(rows);
  std::unordered_map<int, int> index;
  std::vector<int> place;
  for (const Row& row : rows) {
    const auto [found, is_new] =
        index.try_emplace(row.node, static_cast<int>(deck.grids.size()));
    if (is_new) {
      const auto at = known.find(row.node);
      deck.grids.push_back(
          {row.node,
           at == known.end() ? Eigen::Vector3d(0.0, 0.0, 0.0) : at->second});
    }
    place.push_back(6 * found->second + row.component - 1);
  }
  return place;
}

}  // namespace

SparseMatrix read_matrix_market(const std::filesystem::path& path) {
  MarketReader reader(path);
  const std::string header = reader.header();
  const bool dense = header.find(" ARRAY ") != std::string::npos;
  const bool symmetric = header.find(" SYMMETRIC") != std::string::npos;
  const bool known =
      header.starts_with("%%MATRIXMARKET MATRIX ") &&
      header.find("COMPLEX") == std::string::npos &&
      header.find("PATTERN") == std::string::npos &&
      (symmetric || header.find(" GENERAL") != std::string::npos) &&
      header.find("SKEW") == std::string::npos;
  if (!known) {
    reader.fail(
        "this is neither a Matrix Market matrix of real numbers nor OUTPUT4 as "
        "text; a binary OUTPUT4 file is to be written formatted");
  }
  const std::vector<double> size = reader.numbers(dense ? 2 : 3);
  if (size[0] < 1.0 || size[0] != size[1]) {
    reader.fail("the matrix is not square");
  }
  constexpr double most_rows = 5e6;
  if (size[0] > most_rows || size[0] != std::floor(size[0])) {
    reader.fail(fmt::format(
        "{} is no number of rows (up to {:.0e})", size[0], most_rows));
  }
  const Eigen::Index n = static_cast<Eigen::Index>(size[0]);
  Triplets triplets;
  if (dense) {
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = symmetric ? j : 0; i < n; ++i) {
        add(i, j, reader.numbers(1)[0], symmetric, triplets);
      }
    }
  } else {
    for (double k = 0.0; k < size[2]; ++k) {
      const std::vector<double> entry = reader.numbers(3);
      add(reader.index(entry[0], size[0], "row"),
          reader.index(entry[1], size[0], "column"),
          entry[2],
          symmetric,
          triplets);
    }
  }
  reader.end();
  check_single(triplets, path);
  SparseMatrix A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

Deck read_matrix_model(const std::filesystem::path& stiffness,
                       const std::filesystem::path& mass,
                       const std::filesystem::path& dofs) {
  const auto read = [](const std::filesystem::path& path, char letter) {
    return is_output4(path) ? read_output4(path, letter)
                            : read_matrix_market(path);
  };
  const SparseMatrix K = read(stiffness, 'K');
  const SparseMatrix M = read(mass, 'M');
  const std::vector<Row> rows = read_rows(dofs);
  const Eigen::Index n = static_cast<Eigen::Index>(rows.size());
  if (K.rows() != n || M.rows() != n) {
    throw InputError(
        fmt::format(
            "K has {} rows, M {} and the table {}", K.rows(), M.rows(), n),
        dofs.filename().string(),
        "Give the table one line per row of both matrices.");
  }
  check_symmetric(K, stiffness);
  check_symmetric(M, mass);
  check_diagonal(K, rows, stiffness);
  check_diagonal(M, rows, mass);
  Deck deck;
  deck.path = dofs;  // what names the grids
  deck.materials[1] = {.id = 1, .E = 1.0, .rho = 1.0};
  const std::vector<int> place = place_rows(rows, deck);
  const auto size = 6 * static_cast<Eigen::Index>(deck.grids.size());
  deck.given = std::make_shared<const GivenMatrices>(
      GivenMatrices{scatter(K, place, size), scatter(M, place, size)});
  return deck;
}

}  // namespace tapfit::structure

#include "acquisition/readers/named_array.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// "acc:2" taken apart.
struct ColumnName {
  std::string array;
  Index part = 0;  // from 1 on; 0: none
};

ColumnName take_apart(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {text, 0};
  long part = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] =
      std::from_chars(text.data() + colon + 1, end, part);
  if (fault != std::errc{} || stop != end || part <= 0) return {text, 0};
  return {text.substr(0, colon), part};
}

// Attributes are left out: nobody looks for samples there.
[[noreturn]] void throw_not_found(const std::vector<NamedArray>& all,
                                  const std::string& text,
                                  const std::filesystem::path& file) {
  constexpr std::size_t most = 40;
  std::vector<std::string> names;
  for (const NamedArray& array : all) {
    if (array.name.find('@') != std::string::npos) continue;
    names.push_back(names.size() < most ? array.name : "...");
    if (names.size() > most) break;
  }
  throw InputError(fmt::format("there is no variable \"{}\"", text),
                   file.string(),
                   fmt::format("use one of {}", fmt::join(names, ", ")));
}

const NamedArray& numbers_named(const std::vector<NamedArray>& all,
                                const std::string& name,
                                const std::string& text,
                                const std::filesystem::path& file) {
  const NamedArray* array = find_array(all, name);
  if (array == nullptr) throw_not_found(all, text, file);
  if (array->kind == NamedArray::Kind::Damaged) {
    throw_damaged(file, fmt::format("\"{}\"", name));
  }
  if (array->kind == NamedArray::Kind::Numbers && array->values.size() > 0) {
    return *array;
  }
  throw InputError(fmt::format("\"{}\" is no matrix of real numbers", text),
                   file.string(),
                   "name a numeric variable with samples along one side");
}

// Of a name or label, that one can take for such.
constexpr std::size_t longest_text = 1U << 20U;

void put(std::uint64_t number, std::FILE* out) {
  std::fwrite(&number, sizeof number, 1, out);
}
void put(const std::string& text, std::FILE* out) {
  const std::size_t size = std::min(text.size(), longest_text);
  put(size, out);
  std::fwrite(text.data(), 1, size, out);
}

bool get(std::uint64_t& number, std::FILE* in) {
  return std::fread(&number, sizeof number, 1, in) == 1;
}
bool get(std::string& text, std::FILE* in) {
  std::uint64_t size = 0;
  if (!get(size, in) || size > longest_text) return false;
  text.resize(size);
  return std::fread(text.data(), 1, size, in) == size;
}

bool get(NamedArray& array, std::FILE* in) {
  std::uint64_t kind = 0;
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
  std::uint64_t texts = 0;
  if (!get(array.name, in) || !get(kind, in) || !get(rows, in) ||
      !get(columns, in) || !get(texts, in)) {
    return false;
  }
  const double bytes =
      8.0 * static_cast<double>(rows) * static_cast<double>(columns);
  if (bytes > most_matrix_bytes() || kind > 3) return false;
  array.kind = static_cast<NamedArray::Kind>(kind);
  array.values.resize(static_cast<Index>(rows), static_cast<Index>(columns));
  const std::size_t size = rows * columns;
  if (std::fread(array.values.data(), sizeof(double), size, in) != size) {
    return false;
  }
  for (std::uint64_t k = 0; k < texts; ++k) {
    if (!get(array.texts.emplace_back(), in)) return false;
  }
  return true;
}

}  // namespace

Eigen::VectorXd NamedArray::column(Index k) const {
  if (values.cols() > values.rows()) return values.row(k).transpose();
  return values.col(k);
}

const NamedArray* find_array(const std::vector<NamedArray>& all,
                             std::string_view name) {
  const auto found = std::ranges::find(all, name, &NamedArray::name);
  return found == all.end() ? nullptr : &*found;
}

Eigen::VectorXd samples_of(const std::vector<NamedArray>& all,
                           const std::string& text,
                           const std::filesystem::path& file) {
  // Some names end like the number of a column.
  const ColumnName name =
      find_array(all, text) != nullptr ? ColumnName{text, 0} : take_apart(text);
  const NamedArray& array = numbers_named(all, name.array, text, file);
  const Index columns = array.columns();
  if (name.part > columns || (name.part == 0 && columns > 1)) {
    throw InputError(
        fmt::format("\"{}\" has {} columns", text, columns),
        file.string(),
        fmt::format("say which one, for example {}:1", name.array));
  }
  Eigen::VectorXd samples = array.column(std::max<Index>(0, name.part - 1));
  for (Index i = 0; i < samples.size(); ++i) {
    if (std::isfinite(samples[i])) continue;
    throw InputError(
        fmt::format("\"{}\" is no finite number at sample {}", text, i + 1),
        file.string(),
        "cut the record there");
  }
  return samples;
}

Eigen::MatrixXd columns_of(const std::vector<NamedArray>& all,
                           const std::vector<std::string>& names,
                           const std::filesystem::path& file) {
  Eigen::MatrixXd result;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Eigen::VectorXd column = samples_of(all, names[k], file);
    if (k == 0) {
      result.resize(column.size(), static_cast<Index>(names.size()));
    }
    if (column.size() != result.rows()) {
      throw InputError(fmt::format("\"{}\" has {} samples, \"{}\" has {}",
                                   names[k],
                                   column.size(),
                                   names[0],
                                   result.rows()),
                       file.string(),
                       "name variables of one recording");
    }
    result.col(static_cast<Index>(k)) = column;
  }
  return result;
}

double number_of(const std::vector<NamedArray>& all,
                 const std::string& name,
                 const std::filesystem::path& file) {
  const Eigen::VectorXd value = samples_of(all, name, file);
  if (value.size() == 1) return value[0];
  throw InputError(
      fmt::format("\"{}\" has {} values, not one", name, value.size()),
      file.string(),
      "name a variable that holds one number");
}

void ArrayRoom::take(const std::string& name, double values) {
  // A number stands in its array, its record and the table made of records.
  constexpr double places = 3.0;
  values_ += values;
  if (places * sizeof(double) * values_ <= most_matrix_bytes()) return;
  throw InputError(
      name.empty()
          ? fmt::format("has {:.3g} values, more than memory holds", values_)
          : fmt::format("\"{}\" has {:.3g} values, with those before it more "
                        "than memory holds",
                        name,
                        values),
      file_.string(),
      "save a part of it, or the channels in several files; if it is not that "
      "long, the file is damaged");
}

void throw_damaged(const std::filesystem::path& file, const std::string& what) {
  throw InputError(what + " cannot be read",
                   file.string(),
                   "the file is damaged: copy it again, or save it anew");
}

void send_array(const NamedArray& array, std::FILE* out) {
  put(array.name, out);
  put(static_cast<std::uint64_t>(array.kind), out);
  put(static_cast<std::uint64_t>(array.values.rows()), out);
  put(static_cast<std::uint64_t>(array.values.cols()), out);
  put(array.texts.size(), out);
  if (array.values.size() > 0) {
    std::fwrite(array.values.data(),
                sizeof(double),
                static_cast<std::size_t>(array.values.size()),
                out);
  }
  for (const std::string& text : array.texts) put(text, out);
}

std::vector<NamedArray> receive_arrays(std::FILE* in) {
  std::vector<NamedArray> arrays;
  NamedArray array;
  while (get(array, in)) {
    arrays.push_back(std::move(array));
    array = {};
  }
  return arrays;
}

}  // namespace tapfit::acquisition

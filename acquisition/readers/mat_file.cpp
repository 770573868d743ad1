#include "acquisition/readers/mat_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/readers/mat_elements.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, CloseFile>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

// matio's own messages go nowhere; what is wrong is said by InputError.
void say_nothing(int, char*) {}

File open_mat(const std::filesystem::path& file) {
  check_mat_elements(file);
  Mat_LogInitFunc("tapfit", say_nothing);
  File handle(Mat_Open(file.c_str(), MAT_ACC_RDONLY));
  if (handle) return handle;
  throw no_mat_file(file);
}

std::vector<std::string> names_in(mat_t* file) {
  std::vector<std::string> names;
  std::size_t count = 0;
  char** list = Mat_GetDir(file, &count);
  for (std::size_t i = 0; list != nullptr && i < count; ++i) {
    if (list[i] != nullptr) names.emplace_back(list[i]);
  }
  return names;
}

// A file without variables, or one that is listed and does not come.
InputError damaged(const std::filesystem::path& path, const std::string& what) {
  return {what + " cannot be read",
          path.string(),
          "the file is damaged: copy it again, or save it anew"};
}

// A variable that takes more room than there is, however small its file.
InputError too_large(const std::filesystem::path& path,
                     const std::string& name,
                     double values) {
  return {fmt::format(
              "\"{}\" has {:.3g} values, more than memory holds", name, values),
          path.string(),
          "save a part of it; if it is not that long, the file is damaged"};
}

InputError not_found(mat_t* file,
                     const std::filesystem::path& path,
                     const std::string& text) {
  const std::vector<std::string> names = names_in(file);
  if (names.empty()) return damaged(path, "its variables");
  return {fmt::format("there is no variable \"{}\"", text),
          path.string(),
          fmt::format("use one of {}", fmt::join(names, ", "))};
}

template <class Number>
void copy(const matvar_t& variable, Eigen::MatrixXd& values) {
  const auto* from = static_cast<const Number*>(variable.data);
  for (Index i = 0; i < values.size(); ++i) {
    values.data()[i] = static_cast<double>(from[i]);
  }
}

// The variable's numbers; empty for what is no real matrix.
//
// @param most bytes that the file can hold, however well it is packed
std::optional<Eigen::MatrixXd> numbers_of(const matvar_t& variable,
                                          double most) {
  if (variable.rank != 2 || variable.data == nullptr ||
      variable.isComplex != 0) {
    return std::nullopt;
  }
  const std::size_t rows = variable.dims[0];
  const std::size_t columns = variable.dims[1];
  const auto size = static_cast<std::size_t>(variable.data_size);
  if (rows == 0 || columns == 0 || size == 0 ||
      variable.nbytes / size / columns < rows ||
      static_cast<double>(variable.nbytes) > most) {
    return std::nullopt;
  }
  Eigen::MatrixXd values(static_cast<Index>(rows), static_cast<Index>(columns));
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      copy<double>(variable, values);
      return values;
    case MAT_C_SINGLE:
      copy<float>(variable, values);
      return values;
    case MAT_C_INT8:
      copy<mat_int8_t>(variable, values);
      return values;
    case MAT_C_UINT8:
      copy<mat_uint8_t>(variable, values);
      return values;
    case MAT_C_INT16:
      copy<mat_int16_t>(variable, values);
      return values;
    case MAT_C_UINT16:
      copy<mat_uint16_t>(variable, values);
      return values;
    case MAT_C_INT32:
      copy<mat_int32_t>(variable, values);
      return values;
    case MAT_C_UINT32:
      copy<mat_uint32_t>(variable, values);
      return values;
    default:
      return std::nullopt;
  }
}

// "run.force:2" taken apart.
struct Name {
  std::vector<std::string> path;
  Index part = 0;  // from 1 on; 0: none
};

Name parse(const std::string& text) {
  Name name;
  std::string rest = text;
  if (const std::size_t colon = rest.rfind(':'); colon != std::string::npos) {
    long part = 0;
    const char* end = rest.data() + rest.size();
    const auto [stop, fault] =
        std::from_chars(rest.data() + colon + 1, end, part);
    if (fault == std::errc{} && stop == end && part > 0) {
      name.part = part;
      rest.resize(colon);
    }
  }
  for (std::size_t begin = 0; begin <= rest.size();) {
    const std::size_t dot = std::min(rest.find('.', begin), rest.size());
    name.path.push_back(rest.substr(begin, dot - begin));
    begin = dot + 1;
  }
  return name;
}

// Deflate packs a thousand bytes into one at most.
double most_bytes(const std::filesystem::path& path) {
  std::error_code ignored;
  return 1100.0 *
         static_cast<double>(std::filesystem::file_size(path, ignored));
}

// matio takes memory for all that a variable announces before it reads any. A
// value takes a byte at least.
void refuse_tall_tale(mat_t* file,
                      const std::filesystem::path& path,
                      const std::string& name) {
  const Variable info(Mat_VarReadInfo(file, name.c_str()));
  if (!info || info->dims == nullptr) return;
  double values = 1.0;
  for (int k = 0; k < info->rank; ++k) {
    values *= static_cast<double>(info->dims[k]);
  }
  if (values > most_bytes(path)) {
    throw damaged(path, fmt::format("\"{}\"", name));
  }
  if (sizeof(double) * values > most_matrix_bytes()) {
    throw too_large(path, name, values);
  }
}

Eigen::MatrixXd read_matrix(mat_t* file,
                            const std::filesystem::path& path,
                            const std::string& text,
                            const Name& name) {
  refuse_tall_tale(file, path, name.path[0]);
  const Variable variable(Mat_VarRead(file, name.path[0].c_str()));
  if (!variable && std::ranges::count(names_in(file), name.path[0]) > 0) {
    throw damaged(path, fmt::format("\"{}\"", name.path[0]));
  }
  const matvar_t* found = variable.get();
  for (std::size_t k = 1; found != nullptr && k < name.path.size(); ++k) {
    found = found->class_type == MAT_C_STRUCT
                ? Mat_VarGetStructFieldByName(
                      const_cast<matvar_t*>(found), name.path[k].c_str(), 0)
                : nullptr;
  }
  if (found == nullptr) throw not_found(file, path, text);
  const double count = static_cast<double>(found->nbytes) /
                       std::max(1.0, static_cast<double>(found->data_size));
  if (sizeof(double) * count > most_matrix_bytes()) {
    throw too_large(path, text, count);
  }
  auto values = numbers_of(*found, most_bytes(path));
  if (values) return *std::move(values);
  throw InputError(fmt::format("\"{}\" is no matrix of real numbers", text),
                   path.string(),
                   "name a numeric variable with samples along one side");
}

Eigen::VectorXd read_samples(mat_t* file,
                             const std::filesystem::path& path,
                             const std::string& text) {
  const Name name = parse(text);
  Eigen::MatrixXd values = read_matrix(file, path, text, name);
  if (values.cols() > values.rows()) values.transposeInPlace();
  if (name.part > values.cols() || (name.part == 0 && values.cols() > 1)) {
    throw InputError(
        fmt::format("\"{}\" has {} columns", text, values.cols()),
        path.string(),
        fmt::format("say which one, for example {}:1", name.path[0]));
  }
  Eigen::VectorXd samples = values.col(std::max<Index>(0, name.part - 1));
  for (Index i = 0; i < samples.size(); ++i) {
    if (std::isfinite(samples[i])) continue;
    throw InputError(
        fmt::format("\"{}\" is no finite number at sample {}", text, i + 1),
        path.string(),
        "cut the record there");
  }
  return samples;
}

}  // namespace

Eigen::MatrixXd read_mat_columns(const std::filesystem::path& file,
                                 const std::vector<std::string>& names) {
  const File handle = open_mat(file);
  Eigen::MatrixXd result;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Eigen::VectorXd column = read_samples(handle.get(), file, names[k]);
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

double read_mat_number(const std::filesystem::path& file,
                       const std::string& name) {
  const File handle = open_mat(file);
  const Eigen::VectorXd value = read_samples(handle.get(), file, name);
  if (value.size() == 1) return value[0];
  throw InputError(
      fmt::format("\"{}\" has {} values, not one", name, value.size()),
      file.string(),
      "name a variable that holds one number");
}

std::string matlab_library() {
  std::array<int, 3> version{};
  Mat_GetLibraryVersion(&version[0], &version[1], &version[2]);
  return fmt::format("{}.{}.{}", version[0], version[1], version[2]);
}

}  // namespace tapfit::acquisition

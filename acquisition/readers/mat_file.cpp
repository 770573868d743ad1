#include "acquisition/readers/mat_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/readers/mat_elements.hpp"
#include "acquisition/readers/own_process.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>

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

File open_mat(const std::filesystem::path& file, const Progress& progress) {
  check_mat_elements(file, progress);
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

template <class Number>
void copy(const matvar_t& variable, Eigen::MatrixXd& values) {
  const auto* from = static_cast<const Number*>(variable.data);
  for (Index i = 0; i < values.size(); ++i) {
    values.data()[i] = static_cast<double>(from[i]);
  }
}

// Of a variable's class; null for what is no real number.
using Copy = void (*)(const matvar_t&, Eigen::MatrixXd&);
Copy copy_of(matio_classes numbers) {
  switch (numbers) {
    case MAT_C_DOUBLE:
      return &copy<double>;
    case MAT_C_SINGLE:
      return &copy<float>;
    case MAT_C_INT8:
      return &copy<mat_int8_t>;
    case MAT_C_UINT8:
      return &copy<mat_uint8_t>;
    case MAT_C_INT16:
      return &copy<mat_int16_t>;
    case MAT_C_UINT16:
      return &copy<mat_uint16_t>;
    case MAT_C_INT32:
      return &copy<mat_int32_t>;
    case MAT_C_UINT32:
      return &copy<mat_uint32_t>;
    case MAT_C_INT64:
      return &copy<mat_int64_t>;
    case MAT_C_UINT64:
      return &copy<mat_uint64_t>;
    default:
      return nullptr;
  }
}

// Deflate packs a thousand bytes into one at most.
double most_bytes(const std::filesystem::path& path) {
  std::error_code ignored;
  return 1100.0 *
         static_cast<double>(std::filesystem::file_size(path, ignored));
}

// matio takes memory for all that a variable announces before it reads any. A
// value takes a byte at least.
//
// @param room what is left of it
void refuse_tall_tale(mat_t* file,
                      const std::filesystem::path& path,
                      const std::string& name,
                      ArrayRoom room) {
  const Variable info(Mat_VarReadInfo(file, name.c_str()));
  if (!info || info->dims == nullptr) return;
  double values = 1.0;
  for (int k = 0; k < info->rank; ++k) {
    values *= static_cast<double>(info->dims[k]);
  }
  if (values > most_bytes(path)) {
    throw_damaged(path, fmt::format("\"{}\"", name));
  }
  room.take(name, values);
}

// Whether the variable's bytes are as many as its two dimensions ask for.
//
// @param most bytes that the file can hold, however well it is packed
bool is_matrix(const matvar_t& variable, double most) {
  if (variable.rank != 2 || variable.dims == nullptr ||
      variable.data == nullptr || variable.isComplex != 0) {
    return false;
  }
  const std::size_t rows = variable.dims[0];
  const std::size_t columns = variable.dims[1];
  const auto size = static_cast<std::size_t>(variable.data_size);
  return rows > 0 && columns > 0 && size > 0 &&
         variable.nbytes / size / columns >= rows &&
         static_cast<double>(variable.nbytes) <= most;
}

// A matrix of characters: one text for each row, in columns or, in UTF-8, as
// one run of bytes.
std::vector<std::string> texts_of(const matvar_t& variable) {
  const std::size_t rows = variable.dims[0];
  const auto width = static_cast<std::size_t>(variable.data_size);
  const std::size_t columns =
      rows == 1 ? variable.nbytes / width : variable.dims[1];
  const auto* bytes = static_cast<const unsigned char*>(variable.data);
  std::vector<std::string> texts(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      // What is beyond Latin-1 is no letter of a unit or name.
      const unsigned char* at = bytes + width * (column * rows + row);
      const bool latin = width == 1 || (width == 2 && at[1] == 0);
      texts[row] += latin ? static_cast<char>(at[0]) : '?';
    }
    const std::size_t end = texts[row].find_last_not_of(std::string(" \0", 2));
    texts[row] = as_utf8(texts[row].substr(0, end + 1));
  }
  return texts;
}

// Takes a variable apart into arrays.
class Flatten {
 public:
  Flatten(double most, std::vector<NamedArray>& arrays)
      : most_(most), arrays_(arrays) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as structures lie in each other
  void add(const matvar_t* variable, const std::string& name, int depth = 0) {
    constexpr int deepest = 12;
    NamedArray array{.name = name};
    if (variable == nullptr || depth > deepest) {
      arrays_.push_back(std::move(array));
    } else if (variable->class_type == MAT_C_STRUCT) {
      add_fields(*variable, name, depth);
    } else if (variable->class_type == MAT_C_CELL) {
      add_cells(*variable, name, depth);
    } else {
      fill(*variable, array);
      arrays_.push_back(std::move(array));
    }
  }

 private:
  // What the dimensions announce and is not there is not gone through.
  //
  // @param fields pointers that each element has
  static std::size_t elements(const matvar_t& variable, std::size_t fields) {
    double count = variable.data != nullptr && variable.dims != nullptr ? 1 : 0;
    for (int k = 0; k < variable.rank && count > 0; ++k) {
      count *= static_cast<double>(variable.dims[k]);
    }
    const std::size_t there = variable.nbytes / sizeof(matvar_t*) / fields;
    return count < static_cast<double>(there) ? static_cast<std::size_t>(count)
                                              : there;
  }

  void fill(const matvar_t& variable, NamedArray& array) const {
    if (!is_matrix(variable, most_)) return;
    if (variable.class_type == MAT_C_CHAR) {
      array.kind = NamedArray::Kind::Text;
      array.texts = texts_of(variable);
    } else if (const Copy copying = copy_of(variable.class_type)) {
      array.kind = NamedArray::Kind::Numbers;
      array.values.resize(static_cast<Index>(variable.dims[0]),
                          static_cast<Index>(variable.dims[1]));
      copying(variable, array.values);
    }
  }

  void add_fields(const matvar_t& variable,
                  const std::string& name,
                  int depth) {
    const unsigned count =
        Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
    char* const* fields =
        Mat_VarGetStructFieldnames(const_cast<matvar_t*>(&variable));
    const auto* values = static_cast<matvar_t* const*>(variable.data);
    if (fields == nullptr || count == 0) return;
    const std::size_t all = elements(variable, count);
    for (std::size_t k = 0; k < all; ++k) {
      const std::string element =
          k == 0 ? name : fmt::format("{}({})", name, k + 1);
      for (unsigned f = 0; f < count; ++f) {
        const std::string field = fields[f] == nullptr ? "" : fields[f];
        add(values[k * count + f], element + "." + field, depth + 1);
      }
    }
  }

  void add_cells(const matvar_t& variable, const std::string& name, int depth) {
    const auto* cells = static_cast<matvar_t* const*>(variable.data);
    const std::size_t count = elements(variable, 1);
    NamedArray list{.name = name, .kind = NamedArray::Kind::Text};
    for (std::size_t k = 0; k < count; ++k) {
      NamedArray one;
      if (cells[k] != nullptr && cells[k]->class_type == MAT_C_CHAR) {
        fill(*cells[k], one);
      }
      if (one.texts.size() == 1) list.texts.push_back(one.texts[0]);
    }
    if (count > 0 && list.texts.size() == count) {
      arrays_.push_back(std::move(list));
      return;
    }
    for (std::size_t k = 0; k < count; ++k) {
      add(cells[k], fmt::format("{}{{{}}}", name, k + 1), depth + 1);
    }
  }

  double most_;
  std::vector<NamedArray>& arrays_;
};

// @param take gets the arrays of one variable after the other
void read_variables(const std::filesystem::path& path,
                    const Progress& progress,
                    const std::function<void(NamedArray&&)>& take) {
  const File file = open_mat(path, progress);
  const std::vector<std::string> names = names_in(file.get());
  if (names.empty()) throw_damaged(path, "its variables");
  ArrayRoom room(path);
  for (const std::string& name : names) {
    progress("reading", 0.0);
    refuse_tall_tale(file.get(), path, name, room);
    const Variable variable(Mat_VarRead(file.get(), name.c_str()));
    std::vector<NamedArray> arrays;
    if (variable) {
      Flatten(most_bytes(path), arrays).add(variable.get(), name);
    } else {
      arrays.push_back({.name = name, .kind = NamedArray::Kind::Damaged});
    }
    for (NamedArray& array : arrays) {
      room.take(array.name, static_cast<double>(array.values.size()));
      take(std::move(array));
    }
  }
}

}  // namespace

std::vector<NamedArray> read_mat_arrays(const std::filesystem::path& file,
                                        const Progress& progress) {
  std::vector<NamedArray> arrays;
  if (!mat_is_hdf5(file)) {
    read_variables(file, progress, [&](NamedArray&& array) {
      arrays.push_back(std::move(array));
    });
    return arrays;
  }
  in_own_process(
      file,
      [&](std::FILE* out) {
        read_variables(
            file, {}, [&](NamedArray&& array) { send_array(array, out); });
      },
      [&](std::FILE* in) { arrays = receive_arrays(in); },
      progress.stop);
  return arrays;
}

std::string matlab_library() {
  std::array<int, 3> version{};
  Mat_GetLibraryVersion(&version[0], &version[1], &version[2]);
  return fmt::format("{}.{}.{}", version[0], version[1], version[2]);
}

}  // namespace tapfit::acquisition

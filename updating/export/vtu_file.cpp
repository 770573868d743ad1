#include "updating/export/vtu_file.hpp"

#include <fmt/format.h>

namespace tapfit::updating {
namespace {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      safe += c;
    }
  }
  return safe;
}

/// @param attributes besides the format
std::string array_text(const std::string& attributes,
                       const std::string& numbers) {
  return fmt::format(
      "<DataArray {} format=\"ascii\">\n{}</DataArray>\n", attributes, numbers);
}

/// A line per column.
std::string columns_text(const Eigen::MatrixXd& values) {
  std::string text;
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    for (Eigen::Index r = 0; r < values.rows(); ++r) {
      text += fmt::format("{}{:.9g}", r == 0 ? "" : " ", values(r, c));
    }
    text += "\n";
  }
  return text;
}

std::string cells_text(const std::vector<VtuCell>& cells) {
  std::string connectivity;
  std::string offsets;
  std::string types;
  std::size_t end = 0;
  for (const VtuCell& cell : cells) {
    for (const Eigen::Index point : cell.points) {
      connectivity += fmt::format("{} ", point);
    }
    connectivity += "\n";
    end += cell.points.size();
    offsets += fmt::format("{}\n", end);
    types += fmt::format("{}\n", static_cast<int>(cell.type));
  }
  return array_text("type=\"Int64\" Name=\"connectivity\"", connectivity) +
         array_text("type=\"Int64\" Name=\"offsets\"", offsets) +
         array_text("type=\"UInt8\" Name=\"types\"", types);
}

std::string file_text(const char* type, const std::string& content) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n{1}</VTKFile>\n",
      type,
      content);
}

}  // namespace

std::string vtu_text(const VtuMesh& mesh) {
  std::string data;
  for (const auto& [name, values] : mesh.data) {
    data += array_text(
        fmt::format("type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\"",
                    escaped(name),
                    values.rows()),
        columns_text(values));
  }
  return file_text(
      "UnstructuredGrid",
      fmt::format("<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
                  "NumberOfCells=\"{}\">\n<Points>\n{}</Points>\n<Cells>\n{}"
                  "</Cells>\n<PointData>\n{}</PointData>\n</Piece>\n"
                  "</UnstructuredGrid>\n",
                  mesh.points.cols(),
                  mesh.cells.size(),
                  array_text("type=\"Float64\" NumberOfComponents=\"3\"",
                             columns_text(mesh.points)),
                  cells_text(mesh.cells),
                  data));
}

std::string pvd_text(const std::vector<std::string>& files) {
  std::string parts;
  for (std::size_t part = 0; part < files.size(); ++part) {
    parts += fmt::format(
        "<DataSet part=\"{}\" file=\"{}\"/>\n", part, escaped(files[part]));
  }
  return file_text("Collection",
                   fmt::format("<Collection>\n{}</Collection>\n", parts));
}

}  // namespace tapfit::updating

#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/uff/uff_function.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "acquisition/uff/uff_shapes.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/uff_units.hpp"
#include "tui/commands/commands.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace tapfit::tui {
namespace {

using acquisition::printable;
using acquisition::UffDataset;
using acquisition::UffHeader;
using acquisition::UffShape;
using nlohmann::ordered_json;

struct Contents {
  std::vector<std::string> header;
  std::optional<acquisition::UffUnits> units;
  acquisition::UffGeometry geometry;
  std::vector<UffHeader> functions;
  std::vector<UffShape> shapes;
  std::vector<std::string> skipped;
};

void take(const UffDataset& dataset,
          const acquisition::MappedFile& bytes,
          Contents& found) {
  switch (dataset.type) {
    case 151:
      for (std::size_t i = 0;
           i < std::min<std::size_t>(3, dataset.lines.size());
           ++i) {
        found.header.push_back(
            printable(acquisition::column(dataset.lines[i], 0, 80)));
      }
      break;
    case 164:
      found.units = acquisition::read_uff_units(dataset);
      break;
    case 15:
    case 18:
    case 82:
    case 2420:
    case 2411:
    case 2412:
      add_geometry(dataset, found.geometry);
      add_systems(dataset, found.geometry);
      break;
    case 55:
    case 2414:
      found.shapes.push_back(read_shape(dataset));
      break;
    case 58:
      // All of it, so that a broken one is told of here.
      found.functions.push_back(check_function(
          dataset, [&bytes](std::string_view part) { bytes.forget(part); }));
      break;
    case 1858:
      break;
    default:
      found.skipped.push_back(fmt::format(
          "{}: dataset {} is not used", dataset.place, dataset.type));
  }
}

Contents contents_of(const acquisition::UffFile& file,
                     const Progress& progress) {
  Contents found;
  for (std::size_t k = 0; k < file.datasets.size(); ++k) {
    take(file.datasets[k], file.bytes, found);
    progress(
        "reading",
        static_cast<double>(k + 1) / static_cast<double>(file.datasets.size()));
  }
  return found;
}

std::string kind(int type) {
  switch (type) {
    case 1:
      return "time record";
    case 2:
      return "auto spectrum";
    case 3:
      return "cross spectrum";
    case 4:
      return "FRF";
    case 5:
      return "transmissibility";
    case 6:
      return "coherence";
    case 9:
      return "PSD";
    case 18:
      return "mode indicator";
    default:
      return fmt::format("type {}", type);
  }
}

std::string point(const std::optional<Dof>& dof) {
  return dof ? name(*dof) : "-";
}

std::string ordinate(const UffHeader& f) {
  const std::string over = printable(f.numerator.unit);
  const std::string under = printable(f.denominator.unit);
  return under.empty() || under == "NONE" ? over
                                          : fmt::format("({})/{}", over, under);
}

ordered_json json_of(const Contents& found) {
  ordered_json functions = ordered_json::array();
  for (const UffHeader& f : found.functions) {
    functions.push_back({{"kind", kind(f.function_type)},
                         {"response", point(f.response)},
                         {"reference", point(f.reference)},
                         {"values", f.count},
                         {"step", f.step},
                         {"unit", ordinate(f)}});
  }
  ordered_json shapes = ordered_json::array();
  for (const UffShape& s : found.shapes) {
    shapes.push_back({{"mode", s.mode},
                      {"frequency_hz", s.frequency_hz},
                      {"damping_ratio", s.damping_ratio},
                      {"complex", s.complex},
                      {"nodes", s.values.size()}});
  }
  ordered_json result = {{"header", found.header}};
  if (found.units) {
    result["si_factors"] = {{"length", found.units->length},
                            {"force", found.units->force}};
  }
  result["nodes"] = found.geometry.nodes.size();
  result["trace_lines"] = found.geometry.trace_lines.size();
  result["elements"] = found.geometry.elements.size();
  result["functions"] = std::move(functions);
  result["shapes"] = std::move(shapes);
  result["skipped"] = found.skipped;
  return result;
}

std::string text_of(const Contents& found) {
  std::string text;
  for (const std::string& line : found.header) {
    if (!line.empty()) text += line + "\n";
  }
  if (found.units) {
    text += fmt::format("Units: divided by {:g} (length) and {:g} (force) SI\n",
                        found.units->length,
                        found.units->force);
  }
  text += fmt::format("Nodes: {}, trace lines: {}, elements: {}\n",
                      found.geometry.nodes.size(),
                      found.geometry.trace_lines.size(),
                      found.geometry.elements.size());
  if (!found.functions.empty()) {
    TextTable table(
        {"<function", "<response", "<reference", "values", "step", "<unit"});
    for (const UffHeader& f : found.functions) {
      table.add({kind(f.function_type),
                 point(f.response),
                 point(f.reference),
                 fmt::format("{}", f.count),
                 fmt::format("{:.6g}", f.step),
                 ordinate(f)});
    }
    text += table.text();
  }
  if (!found.shapes.empty()) {
    TextTable table({"shape", "frequency Hz", "damping", "nodes", "<values"});
    for (const UffShape& s : found.shapes) {
      table.add({fmt::format("{}", s.mode),
                 fmt::format("{:.6g}", s.frequency_hz),
                 percent(s.damping_ratio),
                 fmt::format("{}", s.values.size()),
                 s.complex ? "complex" : "real"});
    }
    text += table.text();
  }
  for (const std::string& line : found.skipped) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string uff_command(const CommandOptions& options,
                        const Progress& progress) {
  progress("reading", 0.0);
  const acquisition::UffFile file = acquisition::open_uff(options.input);
  if (file.datasets.empty()) {
    throw InputError("has no dataset",
                     options.input,
                     "give a universal file: datasets stand between lines of "
                     "\"    -1\"");
  }
  const Contents found =
      file.bytes.reading([&] { return contents_of(file, progress); });
  return options.json ? json_text(json_of(found)) : text_of(found);
}

}  // namespace tapfit::tui

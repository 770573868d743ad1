// A published figure beside the program's own: paper, tapfit, difference.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

struct PaperRow {
  std::string name;
  std::optional<double> paper;  ///< empty: printed as "-", for example a fit
                                ///< that does not converge
  std::optional<double> tapfit;
  std::string remark;
};

struct PaperTable {
  std::string name;  ///< "Table 3, before updating, Hz"
  std::vector<PaperRow> rows;
  std::vector<std::string> notes;
};

/// Natural frequencies beside the paper's [Hz].
/// @param hz at least as many as of the paper
[[nodiscard]] PaperTable frequency_table(const std::string& name,
                                         const std::vector<double>& paper,
                                         const Eigen::VectorXd& hz);

/// One of the paper's three structures.
struct PaperReport {
  std::string structure;  ///< "truss", "wing", "frame"
  std::vector<PaperTable> tables;
  std::vector<std::string> parameters;  ///< names of the history's columns
  Eigen::MatrixXd history;              ///< parameters over nominal, by step
  std::string history_name = "Convergence";
};

[[nodiscard]] nlohmann::ordered_json paper_json(const PaperReport& report);
[[nodiscard]] std::string paper_text(const PaperReport& report);

}  // namespace tapfit::tui

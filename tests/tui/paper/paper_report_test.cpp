#include "tui/paper/paper_report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

PaperReport sample() {
  PaperReport report;
  report.structure = "truss";
  report.tables = {{"Table 4, %",
                    {{"element 1", 0.85, 0.1, "77.0 GPa"},
                     {"case 1", std::nullopt, std::nullopt, "diverged"}},
                    {"a note"}}};
  report.parameters = {"E:1"};
  report.history.resize(2, 1);
  report.history << 1.0, 1.1;
  report.history_name = "Figure 5, convergence";
  return report;
}

TEST(PaperReport, TextHasThreeColumnsAndTheConvergence) {
  EXPECT_EQ(paper_text(sample()),
            "The paper's truss\n"
            "\n"
            "  Table 4, %  paper  tapfit  difference\n"
            "  element 1    0.85     0.1       -0.75  77.0 GPa\n"
            "  case 1          -       -           -  diverged\n"
            "  a note\n"
            "\n"
            "  Figure 5, convergence, property over its nominal value\n"
            "  step     E:1\n"
            "     0  1.0000\n"
            "     1  1.1000\n");
}

TEST(PaperReport, JsonSaysNullWhereThereIsNoNumber) {
  const auto json = paper_json(sample());
  const auto& rows = json.at("tables").at(0).at("rows");
  EXPECT_NEAR(rows.at(0).at("difference").get<double>(), -0.75, 1e-15);
  EXPECT_TRUE(rows.at(1).at("tapfit").is_null());
  EXPECT_EQ(json.at("history").at("E:1").size(), 2u);
}

}  // namespace
}  // namespace tapfit::tui

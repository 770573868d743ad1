#include "tui/options/csv_table.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

constexpr const char* json = R"({
  "modes": [
    {"frequency_hz": {"value": 2.077116130112, "sd": 1.6e-05}, "by": "auto"},
    {"frequency_hz": {"value": 7.25}, "by": "a, b", "poles": null}],
  "runs": [
    {"file": "run-01.wav", "hits": [
      {"time_s": 0.5, "accepted": true, "reasons": []},
      {"time_s": 1.5, "accepted": false, "reasons": ["too weak", "double"]}]},
    {"file": "run-02.wav", "hits": []},
    {"file": "run-03.wav", "hits": [
      {"time_s": 2.5, "accepted": true, "reasons": []}]}],
  "mac": [[1.0, 0.25], [0.25, 1.0]],
  "comac": {"3Z+": 0.5, "4Z+": 1.0},
  "candidates": [{"where": {"nodes": [1, 2]}, "or": [{"effect": "joint"}]}],
  "none": [],
  "error": 0.5})";

TEST(CsvTable, FieldsOfFieldsAreColumns) {
  EXPECT_EQ(csv_table(json, "modes"),
            "frequency_hz.value,frequency_hz.sd,by,poles\n"
            "2.077116130112,1.6e-05,auto,\n"
            "7.25,,\"a, b\",\n");
}

TEST(CsvTable, WhatLiesInsideHasWhatItLiesInBeforeIt) {
  EXPECT_EQ(csv_table(json, "runs.hits"),
            "file,time_s,accepted,reasons\n"
            "run-01.wav,0.5,true,\n"
            "run-01.wav,1.5,false,too weak; double\n"
            "run-03.wav,2.5,true,\n");
}

TEST(CsvTable, MatricesAndObjectsAreTablesToo) {
  EXPECT_EQ(csv_table(json, "mac"), "1,2\n1.0,0.25\n0.25,1.0\n");
  EXPECT_EQ(csv_table(json, "comac"), "name,value\n3Z+,0.5\n4Z+,1.0\n");
  EXPECT_EQ(csv_table(json, "candidates"),
            "where.nodes,or\n1 2,\"[{\"\"effect\"\":\"\"joint\"\"}]\"\n");
  EXPECT_EQ(csv_table(json, "none"), "");
}

TEST(CsvTable, NamesTheTablesThereAre) {
  for (const char* wrong :
       {"mods", "error", "", "modes.mac", "runs.hits.peak"}) {
    try {
      (void)csv_table(json, wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& fault) {
      EXPECT_NE(std::string(fault.what()).find("there are modes, runs, mac"),
                std::string::npos)
          << fault.what();
    }
  }
}

}  // namespace
}  // namespace tapfit::tui

// What lies outside is named before anything of it is opened.
#include "updating/export/outside_files.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

class OutsideFiles : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_.path() / "test"); }

  [[nodiscard]] std::string refusal(const std::string& input) const {
    try {
      check_inside(folder_.path() / input);
    } catch (const InputError& error) {
      return error.fault();
    }
    return {};
  }
  void write_test(const std::string& fields) const {
    folder_.write("test/test.json", "{\"tapfit\": 1, " + fields + "}");
  }
  [[nodiscard]] std::string named(const std::vector<std::string>& names) const {
    std::string said = "reads from outside its folder: ";
    for (const std::string& name : names) {
      said += (name == names.front() ? "" : ", ") +
              fs::weakly_canonical(folder_.path() / name).string();
    }
    return said;
  }

  testing::TemporaryFolder folder_;
};

// Whoever opened them would tell of points that are none, and of no file.
TEST_F(OutsideFiles, OfTestJsonAreNamedUnread) {
  folder_.write("mesh.csv", "no table\n");
  write_test(R"("geometry": {"file": "../mesh.csv"}, "frfs": "../gone.uff")");
  EXPECT_EQ(refusal("test"), named({"gone.uff", "mesh.csv"}));
  EXPECT_EQ(refusal("test/test.json"), named({"gone.uff", "mesh.csv"}));
}

TEST_F(OutsideFiles, AreNotAskedForWhatTheyInclude) {
  folder_.write("outside.bdf", "INCLUDE 'further.bdf'\n");
  folder_.write("further.bdf", "");
  folder_.write("test/model.bdf", "INCLUDE '../outside.bdf'\n");
  write_test(R"("frfs": "m.uff", "model": "model.bdf")");
  EXPECT_EQ(refusal("test"), named({"outside.bdf"}));
  EXPECT_EQ(refusal("test/model.bdf"), named({"outside.bdf"}));
}

TEST_F(OutsideFiles, ALinkedTestJsonIsOne) {
  folder_.write("elsewhere.json", "no JSON");
  fs::create_symlink(folder_.path() / "elsewhere.json",
                     folder_.path() / "test/test.json");
  EXPECT_EQ(refusal("test"), named({"elsewhere.json"}));
}

TEST_F(OutsideFiles, InTheFolderAreNone) {
  write_test(R"("geometry": {"file": "mesh.csv"}, "frfs": "m.uff",
                "model": {"stiffness": "K.mtx", "mass": "M.mtx",
                          "dofs": "d.csv"})");
  EXPECT_EQ(refusal("test"), "");
}

}  // namespace
}  // namespace tapfit::updating

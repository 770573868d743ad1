#include "updating/prediction/stated_change.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/clamped_beam.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace tapfit::updating {
namespace {

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StatedChange, HasASizeBehindItsPlace) {
  const StatedChange mass = parse_stated_change("added-mass@201=0.010");
  EXPECT_EQ(mass.ref.effect, "added-mass");
  EXPECT_EQ(mass.ref.where.node, 201);
  EXPECT_EQ(mass.sizes, (std::vector<StatedSize>{{0.010, ""}}));
  EXPECT_EQ(parse_stated_change("added-mass@201=10g").sizes,
            (std::vector<StatedSize>{{10.0, "g"}}));
  const StatedChange rotary =
      parse_stated_change("added-mass@201:rotary=10 g,2e-6");
  EXPECT_EQ(rotary.ref.where.variant, "rotary");
  EXPECT_EQ(rotary.sizes, (std::vector<StatedSize>{{10.0, "g"}, {2e-6, ""}}));
  EXPECT_EQ(parse_stated_change("stiffness-loss@60:61=80%").sizes,
            (std::vector<StatedSize>{{80.0, "%"}}));
}

TEST(StatedChange, SaysWhatIsMissingOrNoChange) {
  const auto fault = [](const char* text) {
    return fault_of([text] { (void)parse_stated_change(text); });
  };
  EXPECT_TRUE(holds(fault("added-mass@201"), "no size is stated"));
  EXPECT_TRUE(holds(fault("added-mass@201"), "added-mass@201=0.010"));
  EXPECT_TRUE(holds(fault("added-mass@201="), "no size is stated"));
  EXPECT_TRUE(holds(fault("added-mass@201=heavy"), "\"heavy\" is no number"));
  EXPECT_TRUE(holds(fault("added-mass@201=nan"), "is no number"));
  EXPECT_TRUE(holds(fault("added-mass@201=0.01,"), "\"\" is no number"));
  EXPECT_TRUE(holds(fault("added-mas@201=0.01"), "added-mass"));
  EXPECT_TRUE(holds(fault("channel-gain@acc1=1.1"), "no change of the"));
  EXPECT_TRUE(holds(fault("damping-law=1,1,1"), "no change of the"));
}

/// The clamped beam, 0.942 kg.
class PlacedChange : public ::testing::Test {
 protected:
  PlacedChange() {
    context_.bundle = &bundle_;
    context_.deck = &deck_;
    context_.mass_kg = 0.942;
  }
  [[nodiscard]] EffectInstance place(const std::string& text) const {
    return place_change(parse_stated_change(text), context_);
  }
  [[nodiscard]] std::string fault(const std::string& text) const {
    return fault_of([&] { (void)place(text); });
  }

  acquisition::TestBundle bundle_;
  structure::Deck deck_ = structure::deck_of(testing::beam_text());
  effects::TestContext context_;
};

TEST_F(PlacedChange, HasItsSizesInSiUnits) {
  EXPECT_EQ(place("added-mass@21=0.010").p, std::vector<double>{0.010});
  EXPECT_DOUBLE_EQ(place("added-mass@21=10g").p[0], 0.010);
  EXPECT_DOUBLE_EQ(place("added-mass@21=2lb").p[0], 2 * 0.45359237);
  EXPECT_DOUBLE_EQ(place("ground-spring@21=2kN/m").p[0], 2000.0);
  EXPECT_DOUBLE_EQ(place("stiffness-loss@3=80%").p[0], 0.8);
  EXPECT_EQ(change_text(place("added-mass@21=10g"), context_),
            "added-mass at node 21, mass_kg 0.01");
}

TEST_F(PlacedChange, SaysWhatIsWrongWithItsSizeOrPlace) {
  EXPECT_TRUE(holds(fault("added-mass@21=10st"), "no unit of mass_kg"));
  EXPECT_TRUE(holds(fault("added-mass@21=10st"), "kg, g, mg, lb, oz"));
  EXPECT_TRUE(holds(fault("added-mass@21=1,2"), "2 sizes are stated, not 1"));
  EXPECT_TRUE(holds(fault("added-mass@21:rotary=1"), "inertia_kg_m2"));
  EXPECT_TRUE(holds(fault("added-mass@21=0"), "above zero"));
  EXPECT_TRUE(holds(fault("added-mass@21=-0.01"), "above zero"));
  EXPECT_TRUE(holds(fault("added-mass@999=0.01"), "no grid 999"));
  EXPECT_TRUE(holds(fault("stiffness-loss@99=0.5"), "stiffness-loss"));
}

}  // namespace
}  // namespace tapfit::updating

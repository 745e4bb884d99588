#include "contact/layers.hpp"

#include <gtest/gtest.h>

namespace matpoint {
namespace {

using Bodies = std::vector<std::size_t>;

struct Layered {
    std::vector<ContactMistake> mistakes;
    ContactLayers layers;

    explicit Layered(const std::vector<Bodies>& between)
        : layers(contact_layers({"a", "b", "c", "d"}, between, mistakes)) {}
};

TEST(ContactLayers, BodiesWithoutAContactShareOne) {
    const Layered none({}), tool({Bodies{}});
    EXPECT_EQ(none.layers.count, 1u);
    EXPECT_EQ(tool.layers.layer, (Bodies{0, 0, 0, 0}));

    // a and b are glued to each other, and so are c and d.
    const Layered pairs({{0, 2}, {0, 3}, {1, 2}, {1, 3}});
    EXPECT_EQ(pairs.mistakes.size(), 1u);  // by four contacts, where one law must be between two layers
    const Layered all({{0, 1, 2, 3}});
    EXPECT_TRUE(all.mistakes.empty());
    EXPECT_EQ(all.layers.layer, (Bodies{0, 1, 2, 3}));
    EXPECT_EQ(all.layers.law_between(1, 3), 0);
    EXPECT_EQ(all.layers.law_between(2, 2), -1);
}

TEST(ContactLayers, DifferentLawsBetweenDifferentBodies) {
    const Layered own({{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}});
    EXPECT_TRUE(own.mistakes.empty());
    EXPECT_EQ(own.layers.law_between(2, 1), 1);
    EXPECT_EQ(own.layers.law_between(0, 2), 2);
}

TEST(ContactLayers, WhatCanNotBeIsNamed) {
    const Layered open({{0, 1}});  // c shares with a and with b, which don't share
    ASSERT_EQ(open.mistakes.size(), 1u);
    EXPECT_NE(open.mistakes[0].text.find("\"a\""), std::string::npos) << open.mistakes[0].text;
    EXPECT_NE(open.mistakes[0].text.find("\"b\""), std::string::npos) << open.mistakes[0].text;
    EXPECT_NE(open.mistakes[0].text.find("\"c\""), std::string::npos) << open.mistakes[0].text;

    const Layered twice({{0, 1, 2, 3}, {1, 0}});
    ASSERT_EQ(twice.mistakes.size(), 1u);
    EXPECT_EQ(twice.mistakes[0].contact, 1u);

    const Layered itself({{0, 0, 1}});
    ASSERT_FALSE(itself.mistakes.empty());
    EXPECT_EQ(itself.mistakes[0].text, "\"a\" is named twice");
}

}  // namespace
}  // namespace matpoint

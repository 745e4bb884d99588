// Ranges of values, and what varied values and their pointers are called.

#include <gtest/gtest.h>

#include "study/axis.hpp"

namespace {

using namespace matpoint;

std::string values(const char* range) {
    return Json(range_values(Json::parse(range))).dump();
}

TEST(StudyAxis, RangesReachTheirEnd) {
    EXPECT_EQ(values(R"({"from": 0.1, "to": 0.5, "step": 0.1})"), "[0.1,0.2,0.3,0.4,0.5]");
    EXPECT_EQ(values(R"({"from": 0.8, "to": 0.2, "step": -0.2})"), "[0.8,0.6,0.4,0.2]");
    EXPECT_EQ(values(R"({"from": 1, "to": 1000, "factor": 10})"), "[1,10,100,1000]");
    EXPECT_EQ(values(R"({"from": 0.125, "to": 0.03, "factor": 0.5})"), "[0.125,0.0625,0.03125]");
    EXPECT_EQ(values(R"({"from": 0, "to": 1, "step": 0.4})"), "[0.0,0.4,0.8]") << "the end is not met";
    EXPECT_EQ(range_values(Json::parse(R"({"from": 0, "to": 1, "step": 0.01})")).size(), 101u);
}

TEST(StudyAxis, PointersAreCalledByTheirShortestUniqueEnd) {
    using Texts = std::vector<std::string>;
    EXPECT_EQ(pointer_labels({"/grid/cell_size", "/time/cfl"}), (Texts{"cell_size", "cfl"}));
    EXPECT_EQ(pointer_labels({"/shape_function/type", "/integrator/type"}),
              (Texts{"shape_function", "integrator"}));
    EXPECT_EQ(pointer_labels({"/bodies/a/velocity/0", "/bodies/b/velocity/0"}),
              (Texts{"a/velocity/0", "b/velocity/0"}));
    EXPECT_EQ(pointer_labels({"/shape_function", "/shape_function/type"}),
              (Texts{"/shape_function", "/shape_function/type"}));
}

TEST(StudyAxis, ValuesAreCalledByWhatTellsThemApart) {
    const auto labels = [](const char* list) {
        return value_labels(Json::parse(list).get<std::vector<Json>>());
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(labels(R"([0.125, 0.0625])"), (Texts{"0.125", "0.0625"}));
    EXPECT_EQ(labels(R"([{"type": "linear"}, {"type": "gimp", "domain": "uniform"}])"),
              (Texts{"linear", "gimp"}));
    EXPECT_EQ(labels(R"([{"type": "gimp"}, {"type": "gimp", "domain": "uniform"}])"),
              (Texts{"gimp", "gimp(domain=uniform)"}));
    EXPECT_EQ(labels(R"([0.1234567, 0.1234568])"), (Texts{"0.1234567", "0.1234568"}));
    EXPECT_EQ(labels(R"(["usl", "usf"])"), (Texts{"usl", "usf"}));
}

}  // namespace

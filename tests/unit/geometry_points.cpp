// A user's own particles from a CSV file.

#include "geometry_fixture.hpp"

namespace matpoint {

class GeometryPoints : public GeometryTest {
  protected:
    const Json own = {{"type", "points"}, {"file", "points.csv"}};

    std::string error_of_file(const std::string& text, int dimension = 2) {
        write("points.csv", text);
        return error_of(own, dimension);
    }
};

TEST_F(GeometryPoints, ReadsColumnsInAnyOrder) {
    write("points.csv",
          "\xEF\xBB\xBFvolume, y, x, vy\r\n"
          "# a comment\r\n"
          "0.5, 2, 1, -3\r\n"
          "\r\n"
          "+0.25, 4e-1, -3.5, 0\r\n");
    const auto geometry = make(own, 2);
    ASSERT_NE(geometry->points(), nullptr);
    const auto points = listed(*geometry);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].position, Eigen::Vector3d(1, 2, 0));
    EXPECT_EQ(points[0].velocity, Eigen::Vector3d(0, -3, 0));
    EXPECT_EQ(points[0].volume, 0.5);
    EXPECT_EQ(points[1].position, Eigen::Vector3d(-3.5, 0.4, 0));
    EXPECT_EQ(points[1].volume, 0.25);
    EXPECT_EQ(geometry->bounds().min, Eigen::Vector3d(-3.5, 0.4, 0));
    EXPECT_EQ(geometry->bounds().max, Eigen::Vector3d(1, 2, 0));
}

TEST_F(GeometryPoints, ReadsDomains) {
    write("points.csv", "x,y,dy,volume,dx\n1,2,0.5,0.1,0.2\n2,2,0.2,0.2,1\n");
    const auto points = listed(*make(own, 2));
    ASSERT_TRUE(points[0].half_size && points[1].half_size);
    EXPECT_EQ(*points[0].half_size, Eigen::Vector3d(0.1, 0.25, 0));
    EXPECT_EQ(*points[1].half_size, Eigen::Vector3d(0.5, 0.1, 0));
    EXPECT_SAYS(error_of_file("x,y,volume,dx,dy\n1,2,0.1,0.2,0.5\n1,2,0.11,0.2,0.5\n"),
                "point 2 has volume 0.11");
    EXPECT_SAYS(error_of_file("x,y,volume,dx\n1,2,0.1,0.2\n"), "edges along all axes");
    EXPECT_SAYS(error_of_file("x,y,volume,dx,dy\n1,2,0.1,0,0.5\n"),
                "column \"dx\": expected a number greater than 0");
    write("points.csv", "x,y,volume,dx,dy\n0.5,2,0.31415926535897931,0.2,0.5\n");
    EXPECT_NO_THROW(make(own, Mode::axisymmetric));
}

TEST_F(GeometryPoints, ReportsEveryMistakeWithItsLine) {
    const std::string error = error_of_file(
        "x,y,volume\n"
        "0,0,1\n"
        "0,zero,1\n"
        "0,0\n"
        "0,nan,0\n"
        "1,1,-2\n"
        "1,1 1,2\n");
    EXPECT_SAYS(error, "points.csv:3: column \"y\": expected a finite number, found \"zero\"");
    EXPECT_SAYS(error, "points.csv:4: expected 3 values, found 2");
    EXPECT_SAYS(error, "points.csv:5: column \"y\": expected a finite number, found \"nan\"");
    EXPECT_SAYS(error, "points.csv:5: column \"volume\": expected a number greater than 0, found \"0\"");
    EXPECT_SAYS(error, "points.csv:6: column \"volume\": expected a number greater than 0, found \"-2\"");
    EXPECT_SAYS(error, "points.csv:7: column \"y\": expected a finite number, found \"1 1\"");
}

TEST_F(GeometryPoints, ReportsMistakesInTheHeader) {
    const std::string error = error_of_file("x,z,x,vol\n0,0,0,0\n");
    EXPECT_SAYS(error, "points.csv:1: column \"z\" is not known in 2D");
    EXPECT_SAYS(error, "points.csv:1: column \"x\" is there twice");
    EXPECT_SAYS(
        error,
        "points.csv:1: column \"vol\" is not known in 2D; expected some of x, y, vx, vy, dx, dy, volume");
    EXPECT_SAYS(error, "points.csv:1: column \"y\" is missing");
    EXPECT_SAYS(error, "points.csv:1: column \"volume\" is missing");
}

TEST_F(GeometryPoints, RefusesFilesWithoutPoints) {
    EXPECT_SAYS(error_of_file(""), "it is empty");
    EXPECT_SAYS(error_of_file("x,y,volume\n\n"), "no points");
    EXPECT_SAYS(error_of({{"type", "points"}, {"file", "missing.csv"}}, 2), "missing.csv");
    EXPECT_SAYS(error_of({{"type", "points"}, {"file", "."}}, 2), "is a folder");
}

TEST_F(GeometryPoints, CutsAFloodOfMistakesShort) {
    std::string text = "x,volume\n";
    for (int i = 0; i < 1000; ++i) text += "a,1\n";
    EXPECT_SAYS(error_of_file(text, 1), "and 980 more mistakes");
}

}  // namespace matpoint

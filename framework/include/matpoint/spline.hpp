#pragma once

namespace matpoint {

/// The centred cardinal B-spline N of a degree, in cells: a node's measure of what is around it.
class Spline {
  public:
    /// Of N at x, and of its integrals from -infinity to x.
    struct Values {
        double value;   ///< N(x)
        double mass;    ///< of N
        double moment;  ///< of xi N(xi)
    };

    /// `degree`: 1 (tent) to 3.
    explicit Spline(int degree);

    /// N(x) = 0 from there on.
    double reach() const { return reach_; }
    Values at(double x) const;
    /// How far a half-space -infinity < xi < d reaches beyond the node, by the centroid of N in it,
    /// c = moment(d) / mass(d); from -reach (just touched) to reach (all around the node).
    double surface(double centroid) const;

  private:
    int degree_;
    double reach_;
    double scale_;  ///< 1 / degree!
};

}  // namespace matpoint

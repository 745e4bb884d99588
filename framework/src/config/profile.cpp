#include <matpoint/profile.hpp>

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace matpoint {
namespace {

// muparser would let a formula assign to x, y, z or t.
bool assigns(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=') continue;
        const bool compares = (i > 0 && std::string("=<>!").find(text[i - 1]) != std::string::npos) ||
                              (i + 1 < text.size() && text[i + 1] == '=');
        if (!compares) return true;
    }
    return false;
}

}  // namespace

struct Profile::Formula {
    std::string text;
    mu::Parser parser;
    std::array<double, 4> variables{};  // x, y, z, t

    explicit Formula(std::string formula) : text(std::move(formula)) {
        if (assigns(text)) throw std::invalid_argument("a formula can't assign");
        try {
            parser.DefineConst("pi", std::numbers::pi);
            parser.DefineVar("x", &variables[0]);
            parser.DefineVar("y", &variables[1]);
            parser.DefineVar("z", &variables[2]);
            parser.DefineVar("t", &variables[3]);
            parser.SetExpr(text);
            parser.Eval();
        } catch (const mu::Parser::exception_type& e) {
            throw std::invalid_argument(e.GetMsg());
        }
        if (parser.GetNumResults() != 1) throw std::invalid_argument("a formula has one value");
    }

    double operator()(const std::array<double, 3>& position, double time) {
        variables = {position[0], position[1], position[2], time};
        const double value = parser.Eval();
        if (std::isfinite(value)) return value;
        std::string what = fmt::format("the formula \"{}\" is {} at t = {:.6g} s", text,
                                       std::isnan(value) ? "not a number" : "infinite", time);
        for (const char name : used())
            if (name != 't')
                what += fmt::format(", {} = {:.6g} m", name, position[static_cast<std::size_t>(name - 'x')]);
        throw FormulaError(text, what);
    }

    std::string used() const {
        std::string names;
        for (const auto& variable : parser.GetUsedVar()) names += variable.first;
        return names;
    }
};

Profile::Profile(const Json& value) {
    if (value.is_number()) {
        constant_ = value.get<double>();
    } else if (value.is_string()) {
        formula_ = std::make_unique<Formula>(value.get<std::string>());
    } else if (value.is_object() && value.contains("times") && value.contains("values")) {
        times_ = value.at("times").get<std::vector<double>>();
        values_ = value.at("values").get<std::vector<double>>();
        if (times_.empty()) throw std::invalid_argument("a table has at least one time");
        if (times_.size() != values_.size())
            throw std::invalid_argument("a table has as many values as times");
        if (std::adjacent_find(times_.begin(), times_.end(), std::greater_equal<>()) != times_.end()) {
            throw std::invalid_argument("a table's times increase");
        }
    } else {
        throw std::invalid_argument("neither a number nor a formula nor a table");
    }
}

Profile::Profile(const Profile& other)
    : constant_(other.constant_),
      times_(other.times_),
      values_(other.values_),
      formula_(other.formula_ ? std::make_unique<Formula>(other.formula_->text) : nullptr) {}
Profile::Profile(Profile&&) noexcept = default;
Profile& Profile::operator=(Profile other) noexcept {
    constant_ = other.constant_;
    times_ = std::move(other.times_);
    values_ = std::move(other.values_);
    formula_ = std::move(other.formula_);
    return *this;
}
Profile::~Profile() = default;

double Profile::operator()(const std::array<double, 3>& position, double time) const {
    if (formula_) return (*formula_)(position, time);
    if (times_.empty()) return constant_;
    const auto after =
        static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
    if (after == 0) return values_.front();
    if (after == times_.size()) return values_.back();
    const double part = (time - times_[after - 1]) / (times_[after] - times_[after - 1]);
    return values_[after - 1] + part * (values_[after] - values_[after - 1]);
}

double Profile::settled_at() const {
    if (!formula_) return times_.empty() ? 0 : times_.back();
    const bool varies = formula_->used().find('t') != std::string::npos;
    return varies ? std::numeric_limits<double>::infinity() : 0;
}

double Profile::zero_from() const {
    const bool ends_at_zero = !formula_ && (times_.empty() ? constant_ : values_.back()) == 0;
    return ends_at_zero ? settled_at() : std::numeric_limits<double>::infinity();
}

std::string Profile::variables() const {
    if (formula_) return formula_->used();
    return times_.empty() ? "" : "t";
}

}  // namespace matpoint

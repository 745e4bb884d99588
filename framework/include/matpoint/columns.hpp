#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace matpoint {

using Index = std::ptrdiff_t;

/// Columns of numbers of one length, in one piece of memory, and one spare column to build a new one in.
///
/// Each begins an odd number of cache lines after the one before: columns at the same place of a page would
/// fight for the same lines of the cache (1.3 times slower). Large ones are on huge pages if there are any,
/// and their memory goes back to the system with them.
template <class Real>
class Columns {
  public:
    explicit Columns(int spares = 0) : spares_(spares) {}
    Columns(const Columns& other);
    Columns(Columns&&) noexcept = default;
    Columns& operator=(Columns&&) noexcept = default;

    int count() const { return std::max(static_cast<int>(starts_.size()) - spares_, 0); }
    Index size() const { return size_; }
    Real* operator[](std::size_t column) { return starts_[column]; }
    const Real* operator[](std::size_t column) const { return starts_[column]; }
    /// Where each column begins.
    Real* const* starts() const { return starts_.data(); }
    std::size_t bytes() const { return starts_.size() * column_bytes(); }

    /// `n` numbers in each of `count` columns; the first ones keep what they held, the rest is 0.
    void resize(int count, Index n);
    /// Only the first `n` numbers of each column count from now on.
    void shorten(Index n) { size_ = n; }
    /// The spare column, and its exchange with another one.
    Real* spare() { return (*this)[static_cast<std::size_t>(count())]; }
    void exchange_with_spare(std::size_t column) { std::swap(starts_[column], starts_.back()); }
    /// The spare column takes no memory until it is written to again; what it held is lost.
    void release_spare();

  private:
    /// Gives memory back to where it is from.
    struct Free {
        std::size_t mapped = 0;  ///< bytes from the system; 0: from the heap
        void operator()(Real* memory) const;
    };
    using Memory = std::unique_ptr<Real[], Free>;

    static Memory allocate(std::size_t bytes);
    std::size_t column_bytes() const { return static_cast<std::size_t>(pitch_) * sizeof(Real); }

    int spares_;
    Index size_ = 0, pitch_ = 0;
    std::vector<Real*> starts_;
    Memory memory_;
};

}  // namespace matpoint

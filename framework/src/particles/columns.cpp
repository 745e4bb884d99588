#include <matpoint/columns.hpp>

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace matpoint {

namespace {
constexpr std::size_t cache_line = 64, huge_page = std::size_t{1} << 21;

/// Zeros; pages that are never touched take no memory.
void* allocate(std::size_t bytes) {
    const std::size_t alignment = bytes < huge_page ? cache_line : huge_page;
    const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, whole);
    if (memory == nullptr) throw std::bad_alloc();
    if (alignment == huge_page) madvise(memory, whole, MADV_HUGEPAGE);
    return memory;
}
}  // namespace

template <class Real>
void Columns<Real>::Free::operator()(Real* memory) const {
    std::free(memory);
}

template <class Real>
Columns<Real>::Columns(const Columns& other) : spares_(other.spares_) {
    resize(other.count(), other.size_);
    for (std::size_t c = 0; c < static_cast<std::size_t>(count()); ++c)
        std::copy_n(other[c], size_, (*this)[c]);
}

template <class Real>
void Columns<Real>::resize(int count, Index n) {
    constexpr Index line = cache_line / sizeof(Real);
    const Index lines = (n + line - 1) / line;
    const Index pitch = (lines % 2 == 0 ? lines + 1 : lines) * line;
    const auto columns = static_cast<std::size_t>(count + spares_);

    std::unique_ptr<Real[], Free> fresh;
    if (n > 0)
        fresh.reset(static_cast<Real*>(allocate(columns * static_cast<std::size_t>(pitch) * sizeof(Real))));
    for (std::size_t c = 0; n > 0 && c < static_cast<std::size_t>(count); ++c) {
        Real* const to = fresh.get() + static_cast<Index>(c) * pitch;
        const Index kept = c < static_cast<std::size_t>(this->count()) ? std::min(size_, n) : 0;
        if (kept > 0) std::copy_n((*this)[c], kept, to);
        std::fill(to + kept, to + n, Real(0));
    }
    memory_ = std::move(fresh);
    starts_.resize(columns);
    for (std::size_t c = 0; c < columns; ++c) starts_[c] = memory_.get() + static_cast<Index>(c) * pitch;
    size_ = n;
    pitch_ = pitch;
}

template <class Real>
void Columns<Real>::assign(int count, Index n) {
    if (count != this->count() || n > pitch_) {
        resize(0, 0);
        resize(count,
               n + n / 8);  // more than asked for: bodies that move need a few more blocks now and then
    }
    size_ = n;
    for (std::size_t c = 0; c < static_cast<std::size_t>(count); ++c) std::fill_n((*this)[c], n, Real(0));
}

template class Columns<double>;
template class Columns<float>;

}  // namespace matpoint

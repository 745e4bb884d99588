#include <matpoint/columns.hpp>

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace matpoint {

namespace {
constexpr std::size_t cache_line = 64, huge_page = std::size_t{1} << 21;
constexpr std::size_t page = std::size_t{1} << 16;  // whole pages on every system

constexpr std::size_t rounded_up(std::size_t bytes, std::size_t unit) {
    return (bytes + unit - 1) / unit * unit;
}

class OutOfMemory : public std::bad_alloc {
  public:
    explicit OutOfMemory(std::size_t bytes) {
        std::snprintf(text_.data(), text_.size(), "not enough memory: %.3g MB more were asked for",
                      1e-6 * static_cast<double>(bytes));
    }
    const char* what() const noexcept override { return text_.data(); }

  private:
    std::array<char, 80> text_{};
};

/// Memory of the system that begins with a huge page.
std::byte* map(std::size_t bytes) {
    void* const mapped =
        mmap(nullptr, bytes + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw OutOfMemory(bytes);
    const auto address = reinterpret_cast<std::uintptr_t>(mapped);
    const std::size_t before = rounded_up(address, huge_page) - address;
    std::byte* const begin = static_cast<std::byte*>(mapped) + before;
    if (before > 0) munmap(mapped, before);
    if (before < huge_page) munmap(begin + bytes, huge_page - before);
    madvise(begin, bytes, MADV_HUGEPAGE);
    return begin;
}
}  // namespace

template <class Real>
void Columns<Real>::Free::operator()(Real* memory) const {
    if (mapped > 0)
        munmap(memory, mapped);
    else
        std::free(memory);
}

/// Zeros. Pages of large memory that are never touched take none.
template <class Real>
typename Columns<Real>::Memory Columns<Real>::allocate(std::size_t bytes) {
    if (bytes >= huge_page) {
        const std::size_t whole = rounded_up(bytes, page);
        return Memory(reinterpret_cast<Real*>(map(whole)), {whole});
    }
    const std::size_t whole = rounded_up(bytes, cache_line);
    auto* const memory = static_cast<Real*>(std::aligned_alloc(cache_line, whole));
    if (memory == nullptr) throw OutOfMemory(whole);
    std::fill_n(memory, whole / sizeof(Real), Real(0));
    return Memory(memory);
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

    Memory fresh;
    if (n > 0) fresh = allocate(columns * static_cast<std::size_t>(pitch) * sizeof(Real));
    for (std::size_t c = 0; n > 0 && c < static_cast<std::size_t>(std::min(count, this->count())); ++c)
        std::copy_n((*this)[c], std::min(size_, n), fresh.get() + static_cast<Index>(c) * pitch);
    memory_ = std::move(fresh);
    starts_.resize(columns);
    for (std::size_t c = 0; c < columns; ++c) starts_[c] = memory_.get() + static_cast<Index>(c) * pitch;
    size_ = n;
    pitch_ = pitch;
}

template <class Real>
void Columns<Real>::release_spare() {
    if (memory_.get_deleter().mapped == 0) return;
    // Its whole pages; on the others its neighbours lie, too.
    auto* const begin = reinterpret_cast<std::byte*>(spare());
    const std::size_t before =
        rounded_up(reinterpret_cast<std::uintptr_t>(begin), page) - reinterpret_cast<std::uintptr_t>(begin);
    if (column_bytes() < before + page) return;
    madvise(begin + before, (column_bytes() - before) / page * page, MADV_DONTNEED);
}

template class Columns<double>;
template class Columns<float>;
template class Columns<std::uint32_t>;

}  // namespace matpoint

#include <matpoint/parallel.hpp>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>

namespace matpoint {

namespace {

constexpr Index items_worth_threads = 1024;
int thread_count = 1;

struct Workers {
    tbb::task_arena arena;
    std::optional<tbb::global_control> limit;  ///< lets there be more threads than cores, if asked for
};

Workers& workers() {
    static Workers all;
    return all;
}

}  // namespace

void set_threads(int count) {
    thread_count = std::max(1, count);
    workers().limit.emplace(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(thread_count));
    workers().arena.terminate();
    workers().arena.initialize(thread_count);
}

int threads() {
    return thread_count;
}

void parallel_for(Index count, Index items, const std::function<void(Index)>& body) {
    if (thread_count == 1 || count < 2 || items < items_worth_threads) {
        for (Index i = 0; i < count; ++i) body(i);
        return;
    }
    workers().arena.execute([&] { tbb::parallel_for(Index{0}, count, body); });
}

}  // namespace matpoint

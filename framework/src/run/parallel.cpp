#include <matpoint/parallel.hpp>

#include <omp.h>

#include <algorithm>
#include <exception>
#include <mutex>

namespace matpoint {

namespace {
int thread_count = 1;
}

void set_threads(int count) {
    thread_count = std::max(1, count);
}

int threads() {
    return thread_count;
}

void parallel_for(Index count, const std::function<void(Index)>& body) {
    if (thread_count == 1 || count < 2) {
        for (Index i = 0; i < count; ++i) body(i);
        return;
    }
    std::exception_ptr failure;
    std::mutex mutex;
#pragma omp parallel for schedule(dynamic) num_threads(thread_count)
    for (Index i = 0; i < count; ++i) {
        try {
            body(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace matpoint

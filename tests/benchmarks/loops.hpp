#pragma once

#include "registry/catalogue.hpp"

#include <matpoint/particles.hpp>

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace matpoint {

/// A component from its plugin, as a scene would have it.
template <template <class> class Kind, class S>
std::shared_ptr<Kind<S>> make(const std::string& kind, const Json& json) {
    static PluginCatalogue catalogue;
    catalogue.find(kind, json.at("type"));
    const Parameters::Context context{SpaceId::of<S>(), {}, &catalogue.registry(), nullptr};
    return catalogue.registry().make<Kind<S>>(kind, json, context);
}

inline void report(benchmark::State& state, Index particles) {
    using benchmark::Counter;
    state.counters["time/particle"] =
        Counter(static_cast<double>(state.iterations() * particles), Counter::kIsRate | Counter::kInvert);
}

/// Puts both precisions of a benchmark on the list, as <name>/double and <name>/single.
template <class Double, class Single>
void add(const std::string& name, Double in_double, Single in_single, const Json& json) {
    benchmark::RegisterBenchmark((name + "/double").c_str(), in_double, json);
    benchmark::RegisterBenchmark((name + "/single").c_str(), in_single, json);
}

inline int run(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}  // namespace matpoint

#include "run/run.hpp"

#include <matpoint/output_file.hpp>
#include <matpoint/parallel.hpp>

#include "run/clock.hpp"
#include "run/health.hpp"
#include "run/progress.hpp"
#include "run/resource_error.hpp"
#include "run/result_folder.hpp"
#include "run/rotation.hpp"
#include "run/signals.hpp"
#include "run/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace matpoint {

namespace {

namespace fs = std::filesystem;

/// Seconds of wall time between the states from which a breakdown's last good state is recomputed.
constexpr double refuge_interval = 30;

void write_json(const fs::path& file, const Json& json) {
    OutputFile out(file);
    out.write(json.dump(2));
    out.write("\n");
    out.commit();
}

/// When something that repeats is next due.
class Schedule {
  public:
    Schedule(double every, long every_steps, double time, long step)
        : every_(every), every_steps_(every_steps) {
        if (every_ > 0) next_ = std::floor(time / every_ * (1 + 1e-12)) + 1;
        if (every_steps_ > 0) next_step_ = (step / every_steps_ + 1) * every_steps_;
    }
    /// Whether it is due; moves on to the next time if so.
    bool due(double time, long step) {
        bool now = false;
        if (every_ > 0 && time >= next_ * every_ * (1 - 1e-12)) {
            now = true;
            next_ = std::floor(time / every_ * (1 + 1e-12)) + 1;
        }
        if (every_steps_ > 0 && step >= next_step_) {
            now = true;
            next_step_ = (step / every_steps_ + 1) * every_steps_;
        }
        return now;
    }

  private:
    double every_;
    long every_steps_;
    double next_ = 0;
    long next_step_ = 0;
};

/// One run of a scene, with its files.
class Run {
  public:
    Run(const Scene& scene, PluginCatalogue& catalogue, const RunOptions& options)
        : scene_(scene),
          catalogue_(catalogue),
          options_(options),
          simulation_(Simulation::create(scene, catalogue)) {
        if (options.resume) simulation_->restore(*options.resume);
        for (const ScheduledOutput& output : simulation_->outputs())
            schedules_.emplace_back(output.every, output.every_steps, simulation_->time(),
                                    simulation_->step());
        if (scene.resolved.contains("checkpoint")) {
            const Json& checkpoint = scene.resolved.at("checkpoint");
            checkpoints_.emplace(checkpoint.value("every", 0.0), checkpoint.value("every_steps", 0L),
                                 simulation_->time(), simulation_->step());
            keep_ = checkpoint.at("keep").get<int>();
        }
    }

    RunResult operator()() {
        RunResult result;
        begin_folder();
        const SignalGuard signals;
        Progress progress(options_.progress);
        tell_warnings(progress);
        try {
            open_outputs();
            steps(result, progress);
        } catch (...) {
            tell_failure(result);
        }
        flush_outputs(result);
        if (result.status == RunStatus::broke_down || result.status == RunStatus::unfinished)
            save_after_failure(result);
        progress.clear();
        if (options_.keep_state) result.final_state = simulation_->state();
        result.summary = summarise(*simulation_, catalogue_, clock_, result);
        write_summary(result);
        if (!options_.quiet) print_closing_table(*simulation_, result);
        return result;
    }

  private:
    void begin_folder() {
        folder_ = std::make_unique<ResultFolder>(options_.output);
        remove_stale_states();
        try {
            write_json(options_.output / "resolved.json", with_plugins(scene_.resolved, catalogue_));
        } catch (const std::runtime_error& failure) {
            throw ResourceError(failure.what());
        }
    }

    /// The exception in flight ends the run: what can still be saved is saved, then the reason is told.
    void tell_failure(RunResult& result) const {
        RunStatus status = RunStatus::broke_down;
        std::string reason;
        try {
            throw;
        } catch (const Breakdown& breakdown) {
            reason = breakdown.what();
        } catch (const ComponentFailure& failure) {
            reason = describe_failure({simulation_->step(), simulation_->time(), simulation_->time_step()},
                                      failure);
        } catch (const std::runtime_error& failure) {  // a full disk, say
            status = RunStatus::unfinished;
            reason = failure.what();
        } catch (const std::bad_alloc&) {
            status = RunStatus::unfinished;
            reason = text_of_exception();
        } catch (...) {
            reason = text_of_exception();
        }
        if (result.status != RunStatus::broke_down) result.status = status;
        result.reason += (result.reason.empty() ? "" : "\n") + reason;
    }

    /// Calls a function of an output. What that can't write it throws as std::runtime_error; all else is a
    /// fault of its own.
    template <class Function>
    void call(const ScheduledOutput& scheduled, const char* name, const Function& function) const {
        const Output& output = *scheduled.output;
        try {
            function(*scheduled.output);
        } catch (const std::runtime_error& failure) {
            throw std::runtime_error(fmt::format("{}: {}: {}", output.origin().pointer,
                                                 to_string(output.origin()), failure.what()));
        } catch (...) {
            throw_failure(output.origin(), name);
        }
    }

    void open_outputs() {
        const double resumed_at = options_.resume ? simulation_->time() : -1;
        for (const ScheduledOutput& scheduled : simulation_->outputs()) {
            call(scheduled, "open",
                 [&](Output& output) { output.open(*simulation_, options_.output, resumed_at); });
            if (!options_.resume) write(scheduled);
        }
    }

    void write(const ScheduledOutput& scheduled) const {
        call(scheduled, "write", [&](Output& output) { output.write(*simulation_); });
    }
    void flush(const ScheduledOutput& scheduled) const {
        call(scheduled, "flush", [](Output& output) { output.flush(); });
    }

    /// What was being written in the background is in its file, or the reason why not is told: however the
    /// run ended.
    void flush_outputs(RunResult& result) const {
        for (const ScheduledOutput& scheduled : simulation_->outputs()) {
            try {
                flush(scheduled);
            } catch (...) {
                tell_failure(result);
            }
        }
    }

    void tell_warnings(Progress& progress) {
        const std::vector<std::string>& warnings = simulation_->warnings();
        if (told_ < warnings.size()) progress.clear();
        for (; told_ < warnings.size(); ++told_)
            if (options_.warn) options_.warn(warnings[told_]);
    }

    void steps(RunResult& result, Progress& progress) {
        double refuge_due = refuge_interval;
        stepping_ = true;
        if (simulation_->step() == 0) simulation_->measure_error();
        stepping_ = false;
        while (!simulation_->finished()) {
            if (signals_received() ||
                (options_.stop_after_steps && simulation_->step() >= *options_.stop_after_steps)) {
                result.status = RunStatus::interrupted;
                result.reason = "interrupted; go on with: matpoint restart " + save().string();
                return;
            }
            good_step_ = simulation_->step();
            stepping_ = true;
            {
                const StepTimer timer(clock_);
                simulation_->advance();
            }
            simulation_->measure_error();
            stepping_ = false;
            tell_warnings(progress);
            ++clock_.steps;
            clock_.particle_steps += static_cast<double>(simulation_->particle_count());
            const auto& outputs = simulation_->outputs();
            for (std::size_t k = 0; k < outputs.size(); ++k)
                if (schedules_[k].due(simulation_->time(), simulation_->step())) {
                    folder_->expect_in_place();
                    write(outputs[k]);
                }
            if (checkpoints_ && checkpoints_->due(simulation_->time(), simulation_->step())) {
                save();
                prune_checkpoints(checkpoint_folder(), keep_);
            }
            if (clock_.wall_seconds() > refuge_due) {
                refuge_due = clock_.wall_seconds() + refuge_interval;
                save(refuge_file());
            }
            progress.show(*simulation_, clock_);
        }
        folder_->expect_in_place();
        for (const ScheduledOutput& scheduled : simulation_->outputs()) write(scheduled);
    }

    fs::path checkpoint_folder() const { return options_.output / "checkpoints"; }
    fs::path refuge_file() const { return checkpoint_folder() / "last_good.h5"; }

    /// Checkpoints of an earlier run into the same folder would pass for this one's.
    void remove_stale_states() const {
        if (!fs::exists(checkpoint_folder())) return;
        remove_checkpoints_after(checkpoint_folder(), options_.resume ? options_.resume->step : -1);
        fs::remove(refuge_file());
    }

    fs::path save() const {
        fs::path file = checkpoint_path(checkpoint_folder(), simulation_->step());
        save(file);
        return file;
    }
    /// After the files of the steps before: a run that goes on from here does not write them again.
    void save(const fs::path& file) const {
        for (const ScheduledOutput& scheduled : simulation_->outputs()) flush(scheduled);
        write_state(file);
    }
    void write_state(const fs::path& file) const {
        folder_->expect_in_place();
        fs::create_directory(checkpoint_folder());
        write_checkpoint(file, simulation_->state());
    }

    void save_after_failure(RunResult& result) {
        const std::string what = stepping_ ? "\nThe last good state" : "\nThe state";
        try {
            if (stepping_) recompute(good_step_);
            restore_folder();
            const fs::path file = checkpoint_path(checkpoint_folder(), simulation_->step());
            write_state(file);
            result.reason += what + " is saved in " + file.string();
        } catch (...) {
            result.reason += what + " could not be saved: " + text_of_exception();
        }
    }

    /// Runs being deterministic, the state before a step that failed is recomputed rather than kept at hand:
    /// from the latest state on disk, or from the start.
    void recompute(long step) {
        auto again = Simulation::create(scene_, catalogue_);
        if (const auto start = latest_state(step)) again->restore(*start);
        if (again->step() == 0) again->measure_error();
        while (again->step() < step) {
            again->advance();
            again->measure_error();
        }
        simulation_ = std::move(again);
    }

    std::optional<CheckpointData> latest_state(long before) const {
        std::optional<CheckpointData> latest = options_.resume;
        std::error_code missing;
        for (const auto& entry : fs::directory_iterator(checkpoint_folder(), missing)) {
            if (entry.path().extension() != ".h5") continue;
            CheckpointData candidate = read_checkpoint(entry.path());
            if (candidate.step <= before && (!latest || candidate.step > latest->step))
                latest = std::move(candidate);
        }
        return latest;
    }

    /// A folder that somebody removed is made anew, so that the state is not lost.
    void restore_folder() {
        if (!fs::exists(options_.output)) folder_ = std::make_unique<ResultFolder>(options_.output);
    }

    void write_summary(RunResult& result) {
        try {
            folder_->expect_in_place();
            write_json(options_.output / "summary.json", result.summary);
        } catch (const std::runtime_error& failure) {
            if (result.status == RunStatus::completed) result.status = RunStatus::unfinished;
            result.reason += std::string(result.reason.empty() ? "" : "\n") + failure.what();
        }
        if (result.status == RunStatus::completed) {
            std::error_code ignored;
            fs::remove(refuge_file(), ignored);
        }
    }

    const Scene& scene_;
    PluginCatalogue& catalogue_;
    const RunOptions& options_;
    std::unique_ptr<ResultFolder> folder_;
    std::unique_ptr<Simulation> simulation_;
    std::vector<Schedule> schedules_;
    std::optional<Schedule> checkpoints_;
    int keep_ = 2;
    std::size_t told_ = 0;  ///< warnings
    RunClock clock_;
    bool stepping_ = false;  ///< whether the present state is that of a step that has not ended well
    long good_step_ = 0;     ///< the step before
};

}  // namespace

RunResult run_scene(const Scene& scene, PluginCatalogue& catalogue, const RunOptions& options) {
    return Run(scene, catalogue, options)();
}

Scene scene_of(const CheckpointData& checkpoint, PluginCatalogue& catalogue) {
    return resolve_scene(
        parse_document(checkpoint.scene, std::filesystem::path(checkpoint.folder) / "checkpoint.json"),
        catalogue);
}

}  // namespace matpoint

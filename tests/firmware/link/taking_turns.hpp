#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace kfast::test {

/// A program that runs for ever, in steps: it and its caller take turns, and never run at once.
class TakingTurns {
public:
    explicit TakingTurns(std::function<void()> program) : program_{std::move(program)} {}
    TakingTurns(const TakingTurns&) = delete;
    TakingTurns& operator=(const TakingTurns&) = delete;
    ~TakingTurns()
    {
        if (!thread_.joinable())
            return;
        is_over_ = true;
        pass_to(Whose::program);
        thread_.join();
    }

    /// Lets the program run until it pauses. What it throws is thrown here.
    void step()
    {
        if (!thread_.joinable())
            thread_ = std::thread{[this] { run(); }};
        pass_to(Whose::program);
        wait_for(Whose::caller);
        if (thrown_)
            std::rethrow_exception(std::exchange(thrown_, nullptr));
    }
    /// By the program: goes on with the next step, or never.
    void pause()
    {
        pass_to(Whose::caller);
        wait_for(Whose::program);
        if (is_over_)
            throw Over{};
    }

private:
    struct Over {};
    enum class Whose { caller, program };

    void run()
    {
        wait_for(Whose::program);
        try {
            if (!is_over_)
                program_();
        } catch (const Over&) {
        } catch (...) {
            thrown_ = std::current_exception();
        }
        pass_to(Whose::caller);
    }
    void pass_to(Whose whose)
    {
        const std::lock_guard guard{mutex_};
        turn_ = whose;
        changed_.notify_all();
    }
    void wait_for(Whose whose)
    {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [&] { return turn_ == whose; });
    }

    std::function<void()> program_;
    std::mutex mutex_;
    std::condition_variable changed_;
    Whose turn_ = Whose::caller;
    bool is_over_ = false;
    std::exception_ptr thrown_;
    std::thread thread_;
};

}

#include "host/link/on_each.hpp"

#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"

#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace kfast {
namespace {

using Failures = std::vector<std::optional<Failure>>;

std::optional<Failure> failure_of(const std::function<void()>& act)
{
    try {
        act();
        return std::nullopt;
    } catch (const Failure& failure) {
        return failure;
    } catch (const std::exception& error) { // must not end the program from a thread
        return Failure{error.what()};
    }
}

/// Whoever is interrupted need not be told so by every device.
bool has_interruption(const Failures& failures)
{
    for (const auto& failure : failures)
        if (failure && failure->status() == ExitStatus::interrupted)
            return true;
    return false;
}

void report(const Failures& failures, std::span<const RemoteDevice> devices)
{
    if (has_interruption(failures))
        throw Interrupted{};
    std::string text;
    std::optional<ExitStatus> status;
    for (std::size_t index = 0; index < devices.size(); ++index) {
        if (!failures[index])
            continue;
        text += (text.empty() ? "" : "\nkfast: ") + devices[index].name() + ": " + failures[index]->what();
        status = status.value_or(failures[index]->status());
    }
    if (status)
        throw Failure{text, *status};
}

}

void on_each(std::span<RemoteDevice> devices, const std::function<void(RemoteDevice&, std::size_t)>& act)
{
    Failures failures(devices.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t index = 0; index < devices.size(); ++index)
            threads.emplace_back(
                [&, index] { failures[index] = failure_of([&] { act(devices[index], index); }); });
    }
    report(failures, devices);
}

}

#include "tests/host/link/pretend_hidapi.hpp"

#include <algorithm>
#include <cerrno>
#include <hidapi.h>

struct hid_device_ {};

namespace kfast::test {

PretendHidapi& pretend_hidapi()
{
    static PretendHidapi hidapi;
    return hidapi;
}

namespace {

hid_device_ the_device;

int next_of(std::deque<HidResult>& results)
{
    const HidResult result = results.front();
    results.pop_front();
    errno = result.error;
    return result.value;
}

}

}

using kfast::test::pretend_hidapi;

extern "C" {

hid_device_info* hid_enumerate(unsigned short, unsigned short)
{
    hid_device_info* first = nullptr;
    hid_device_info** next = &first;
    for (auto& entry : pretend_hidapi().plugged_in) {
        *next = new hid_device_info{};
        (*next)->path = entry.path.data();
        (*next)->usage_page = entry.usage_page;
        (*next)->serial_number = const_cast<wchar_t*>(entry.serial);
        next = &(*next)->next;
        ++pretend_hidapi().open;
    }
    return first;
}

void hid_free_enumeration(hid_device_info* list)
{
    while (list != nullptr) {
        const hid_device_info* const old = list;
        list = list->next;
        delete old;
        --pretend_hidapi().open;
    }
}

hid_device* hid_open_path(const char*)
{
    if (!pretend_hidapi().opens)
        return nullptr;
    ++pretend_hidapi().open;
    return &kfast::test::the_device;
}

void hid_close(hid_device*) { --pretend_hidapi().open; }

const wchar_t* hid_error(hid_device*) { return L"it is asleep"; }

int hid_write(hid_device*, const unsigned char* data, std::size_t length)
{
    pretend_hidapi().written.emplace_back(data, data + length);
    return kfast::test::next_of(pretend_hidapi().writes);
}

int hid_read_timeout(hid_device*, unsigned char* data, std::size_t length, int)
{
    const int count = kfast::test::next_of(pretend_hidapi().reads);
    for (int at = 0; at < std::min(count, static_cast<int>(length)); ++at)
        data[at] = static_cast<unsigned char>(at);
    return count;
}
}

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::test {

/// A gzip file of one member.
std::string gzipped(std::string_view content);

using Files = std::vector<std::pair<std::string, std::string>>; ///< paths and contents

/// A zip file; encrypted unless the password is empty.
std::string zipped(const Files& files, const std::string& password = "");

}

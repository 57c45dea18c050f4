// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::report {

/// Parts of a report's page. Texts are escaped, `content` is not. Nothing of an empty content.
std::string page_section(const std::string& title, const std::string& content);

/// A table; on a narrow page each row becomes a block, its cells with their headings.
std::string page_table(const std::string& caption, const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows);

/// A chart or drawing with its heading, and several side by side.
std::string panel_of(const std::string& heading, const std::string& picture);
std::string panels(const std::string& content);

/// What the marks of a picture mean; `style` is the mark's own class.
std::string box_key(const std::string& style, const std::string& words);
std::string line_key(const std::string& style, const std::string& words);
std::string dot_key(const std::string& style, const std::string& words);
std::string legend(const std::string& keys);

}  // namespace torquewright::report

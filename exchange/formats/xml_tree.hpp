#pragma once

#include <cpl_minixml.h>

#include <memory>
#include <string>
#include <string_view>

namespace furrow::exchange {

struct XmlDeleter {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
/// A parsed document: a list of siblings. No entity, schema or link of it is ever fetched.
using XmlTree = std::unique_ptr<CPLXMLNode, XmlDeleter>;

/// Deeper elements are not looked at; no land file nests a tenth of it.
inline constexpr int deepest_element = 200;

/// Null if `bytes` is no XML, or nests deeper than any land file.
XmlTree xml_tree(const std::string& bytes);

/// The outermost element of a document; null if there is none.
const CPLXMLNode* root(const CPLXMLNode* tree);

/// Whether `node` is the element `name`, whatever its namespace prefix.
bool is_element(const CPLXMLNode* node, std::string_view name);

/// The text of an attribute, or of a child element, called `name` without prefix; empty if none.
std::string attribute(const CPLXMLNode* node, std::string_view name);
std::string child_text(const CPLXMLNode* node, std::string_view name);

/// The name of an element or attribute without its prefix.
std::string_view local_name(const CPLXMLNode* node);

/// Calls `visit` for every child element of `node`, in file order.
template <class Visit>
void for_each_child(const CPLXMLNode* node, Visit visit) {
  for (const CPLXMLNode* child = node->psChild; child; child = child->psNext) {
    if (child->eType == CXT_Element) visit(child);
  }
}

}  // namespace furrow::exchange

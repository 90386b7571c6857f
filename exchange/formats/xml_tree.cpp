#include "exchange/formats/xml_tree.hpp"

namespace furrow::exchange {

XmlTree xml_tree(const std::string& bytes) { return XmlTree{CPLParseXMLString(bytes.c_str())}; }

const CPLXMLNode* root(const CPLXMLNode* tree) {
  for (; tree; tree = tree->psNext) {
    if (tree->eType == CXT_Element && tree->pszValue[0] != '?') return tree;
  }
  return nullptr;
}

std::string_view local_name(const CPLXMLNode* node) {
  const std::string_view name = node->pszValue;
  const auto colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is_element(const CPLXMLNode* node, std::string_view name) {
  return node->eType == CXT_Element && local_name(node) == name;
}

std::string attribute(const CPLXMLNode* node, std::string_view name) {
  for (const CPLXMLNode* child = node->psChild; child; child = child->psNext) {
    if (child->eType == CXT_Attribute && local_name(child) == name && child->psChild) {
      return child->psChild->pszValue;
    }
  }
  return {};
}

std::string child_text(const CPLXMLNode* node, std::string_view name) {
  for (const CPLXMLNode* child = node->psChild; child; child = child->psNext) {
    if (!is_element(child, name)) continue;
    for (const CPLXMLNode* part = child->psChild; part; part = part->psNext) {
      if (part->eType == CXT_Text) return part->pszValue;
    }
  }
  return {};
}

}  // namespace furrow::exchange

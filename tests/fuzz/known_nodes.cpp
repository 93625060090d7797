// The nodes of maps and sets are joined in libstdc++, unseen by the memory sanitizer: it is told what is
// written there. Linked with --wrap.
#include <sanitizer/msan_interface.h>

#include <map>

using Node = std::_Rb_tree_node_base;

extern "C" {

void __real__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(bool, Node*, Node*, Node&);

void __wrap__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(bool is_left, Node* node,
                                                                              Node* parent, Node& header)
{
    __real__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(is_left, node, parent, header);
    __msan_unpoison(node, sizeof *node);
}
}

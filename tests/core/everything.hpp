#pragma once

#include <string_view>

namespace kfast::test {

/// 60 x 40 px, 30 frames: something of everything that a scene can have.
inline constexpr std::string_view everything = R"scene(
kfast 1
canvas 60 40 background="#203040" frames=30
palette { glass "#ff000080" }
symbol wheel {
    object tyre stroke=white width=2 join=round cap=round {
        key 0 { circle 0 0 r=5 }
        key 15 law=accelerate { polygon -5 -5 5 -5 5 5 -5 5 }
        key 30 { circle 0 0 r=5 }
    }
    object hub fill=glass stroke=silver opacity=0.5 { circle 0 0 r=2 }
}
symbol cart {
    group opacity=0.75 {
        use wheel 10 20 { key 0 rotate=0; key 30 rotate=720 }
        use wheel 30 20 scale=1.5 mirror=x { key 0 opacity=1; key 30 opacity=0.25 law=decelerate }
    }
    object box fill=olive stroke=yellow width=1.5 order=-1 { rect 5 5 30 12 corner=3 }
}
group far opacity=0.5 scale=0.5 rotate=10 {
    use cart 4 4
    group { use cart 40 10 mirror=both; key 0 opacity=1; key 10 opacity=0; key 20 opacity=1 }
}
use cart 0 8 { key 0 x=0 law="bezier(0.2,-1,0.8,2)"; key 30 x=20 scale=1.25 }
object morph fill="#ff8000" stroke="#ffffffc0" width=3 rule=even-odd order=3 {
    key 0 law=accelerate match=length { circle 15 20 r=12; circle 15 20 r=6 }
    key 10 law-x=decelerate law-y="steps(5)" width=0 fill=blue { polygon 10 3 17 10 10 17 3 10; rect 30 20 20 15 }
    key 20 { path "M 5 5 C 60 0 0 40 55 35 Q 30 0 5 30 Z" }
    key 25 visible=#false { empty }
    key 27 visible=#true width=6 order=-7 fill=glass
    key 30 { circle 15 20 r=12 }
}
object zigzag stroke="#00ff80" width=5 cap=square join=miter miter=8 {
    key 0 scale-x=-1 { line 0 0 60 10 0 20 60 30 0 40 }
    key 30 scale-x=0 { line 30 0 31 40 32 0 33 40 34 0 35 40 }
}
clip walk from=0 to=20 loop=ping-pong
event 10 step
)scene";

}

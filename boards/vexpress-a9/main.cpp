#include "boards/vexpress-a9/board.hpp"
#include "firmware/run/run.hpp"

int main()
{
    kfast::vexpress_a9::Board board;
    while (board.wants_to_run())
        kfast::run(board);
    return 0;
}

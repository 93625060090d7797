#include "boards/lm3s6965evb/board.hpp"
#include "firmware/run/run.hpp"

int main()
{
    kfast::lm3s6965evb::Board board;
    while (board.wants_to_run())
        kfast::run(board);
    return 0;
}

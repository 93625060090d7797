#include "boards/template/board.hpp"
#include "firmware/run/run.hpp"

int main()
{
    kfast::board_template::Board board;
    kfast::run(board);
    return 0;
}

/* The second stage of booting. The boot ROM copies these at most 252 bytes from the beginning of flash to
   0x2004'1F00 and jumps there with LR = 0: the flash controller is set up so that flash can be read like memory,
   and the program begins as its vectors say. Flash functions call a copy of it, with LR to return to, after they
   have taken the controller for themselves. Runs at any address divisible by four; uses r0 to r3.

   Reads with command 03h, which every flash chip has: 31.25 MHz, within the 50 MHz that they allow for it. */

    .equ xip_ssi, 0x18000000
    .equ ctrlr0, 0x00
    .equ ctrlr1, 0x04
    .equ ssienr, 0x08
    .equ baudr, 0x14
    .equ spi_ctrlr0, 0xF4

    .equ clock_divider, 4

    /* One wire each way, 32 bits at a time, received after command and address have been sent. */
    .equ frame_32_bits, 31 << 16
    .equ send_then_receive, 3 << 8

    .equ read_command, 0x03 << 24
    .equ command_8_bits, 2 << 8
    .equ address_24_bits, 6 << 2

    .equ vectors, 0x10000100
    .equ vtor, 0xE000ED08

    .syntax unified
    .cpu cortex-m0plus
    .thumb
    .section .text
    .balign 4

    ldr r3, =xip_ssi
    movs r2, #0
    str r2, [r3, #ssienr] /* off: the other registers can be written only so */
    movs r1, #clock_divider
    str r1, [r3, #baudr]
    ldr r1, =frame_32_bits | send_then_receive
    str r1, [r3, #ctrlr0]
    ldr r1, =read_command | command_8_bits | address_24_bits
    ldr r0, =xip_ssi + spi_ctrlr0
    str r1, [r0]
    str r2, [r3, #ctrlr1] /* a single word for every read */
    movs r1, #1
    str r1, [r3, #ssienr]

    mov r0, lr
    cmp r0, #0
    beq start_program
    bx lr

start_program:
    ldr r0, =vectors
    ldr r1, =vtor
    str r0, [r1]
    ldm r0!, {r1, r2}
    msr msp, r1
    bx r2

    .ltorg

"""A plot of time per particle and step against the number of particles, as SVG."""
import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 360, 60, 20, 20, 50


def growth_plot(points, bandwidth):
    """points: (particles, ns measured, ns that memory alone would take at so many GB/s)."""
    low, high = math.floor(math.log10(points[0][0])), math.ceil(math.log10(points[-1][0]) - 0.01)
    largest = max(max(time, memory) for _, time, memory in points)
    tick = next(t for t in (5, 10, 20, 50, 100, 200, 500, 1000) if largest / t <= 8)
    top = tick * math.ceil(1.05 * largest / tick)

    def x(count):
        return LEFT + (math.log10(count) - low) / max(1, high - low) * (WIDTH - LEFT - RIGHT)

    def y(time):
        return HEIGHT - BOTTOM - time / top * (HEIGHT - TOP - BOTTOM)

    def text(px, py, words, anchor="middle", more=""):
        return f'<text x="{px:.1f}" y="{py:.1f}" text-anchor="{anchor}"{more}>{words}</text>'

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']
    for k in range(low, high + 1):
        parts += [f'<path d="M{x(10**k):.1f} {y(0):.1f}V{y(top):.1f}" stroke="#ddd"/>',
                  text(x(10**k), y(0) + 18, f'10<tspan dy="-5" font-size="10">{k}</tspan>')]
    for k in range(0, top + 1, tick):
        parts += [f'<path d="M{LEFT} {y(k):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>', text(LEFT - 6, y(k) + 4, k, "end")]
    for column, colour, dashes, words in ((1, "#1f77b4", "", "measured"), (2, "#888", "6 4", f"its bytes at {bandwidth} GB/s")):
        path = "L".join(f"{x(p[0]):.1f} {y(p[column]):.1f}" for p in points)
        parts.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dashes}"/>')
        beneath = max(p[column] for p in points if x(p[0]) < x(points[0][0]) + 10 * len(words))
        parts.append(text(x(points[0][0]), y(beneath) - 8, words, "start", f' fill="{colour}"'))
    parts += [f'<circle cx="{x(p[0]):.1f}" cy="{y(p[1]):.1f}" r="4" fill="#1f77b4"/>' for p in points]
    middle = (TOP + HEIGHT - BOTTOM) / 2
    parts += [text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, "particles"),
              text(16, middle, "ns per particle and step", "middle", f' transform="rotate(-90 16 {middle:.0f})"'), "</svg>"]
    return "\n".join(parts) + "\n"

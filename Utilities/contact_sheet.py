"""Parts of make-contact-sheets: times and captions from `nexrad3d info --json`, sheets of pictures (also of
make-pictures), the index.

  contact_sheet.py middle INFO                     middle of the file's time, and the reach of its radar
  contact_sheet.py sheet INFO LABEL SHEET MAP...   the maps, three in a row, with a caption; prints the caption
  contact_sheet.py pictures TEXT SHEET PICTURE...  pictures of one size, three in a row, with a caption
  contact_sheet.py pairs TEXT SHEET COLUMNS WIDTH PART LABEL BEFORE AFTER...
                                                   pairs of pictures, each WIDTH pixels wide, COLUMNS pairs in a row;
                                                   PART: whole, or map without what is about it
  contact_sheet.py index SHEETS LEFT_OUT PAGE      an HTML page of lines "sheet, caption" and "input, reason"
"""

import datetime
import html
import json
import sys

import numpy

TERMINAL_PATTERNS = (80, 90)  # the VCPs of Terminal Doppler Weather Radar
IN_A_ROW = 3
CAPTION = 46  # pixels


def described(path):
    with open(path, encoding="utf-8") as file:
        volume = json.load(file)[0]
    if not volume["sweeps"] or not volume["start"]:
        sys.exit("no ray can be read")
    return volume


def middle(volume):
    start, end = (
        datetime.datetime.fromisoformat(volume[key].replace("Z", "+00:00")) for key in ("start", "end")
    )
    return (start + (end - start) / 2).replace(microsecond=0)


def caption(volume, label):
    elevations = [sweep["elevation_deg"] for sweep in volume["sweeps"]]
    parts = [
        label,
        volume["site"] or "site unknown",
        f"{middle(volume):%Y-%m-%d %H:%M:%S} UTC",
        f"VCP {volume['vcp'] or 'unknown'}",
        f"message {volume['message_type']}",
        f"cuts: {len(elevations)}, {min(elevations):.1f} to {max(elevations):.1f}°",
    ]
    if not volume["complete"]:
        parts.append("not complete")
    return " · ".join(parts)


def rows_of(pictures):
    """The pictures beside and below each other; black where the last row has none."""
    pictures = list(pictures)
    while len(pictures) > IN_A_ROW and len(pictures) % IN_A_ROW:
        pictures.append(numpy.zeros_like(pictures[0]))
    rows = [numpy.hstack(pictures[first : first + IN_A_ROW]) for first in range(0, len(pictures), IN_A_ROW)]
    return numpy.vstack(rows)


def write_sheet(text, sheet, maps):
    import matplotlib
    from PIL import Image

    matplotlib.use("Agg")
    from matplotlib import pyplot

    pixels = rows_of(pyplot.imread(path)[:, :, :3] for path in maps)
    height, width = pixels.shape[:2]
    figure = pyplot.figure(figsize=(width / 100, (height + CAPTION) / 100), dpi=100, facecolor="black")
    figure.figimage(pixels)
    figure.text(12 / width, 1 - CAPTION / 2 / (height + CAPTION), text, color="white", fontsize=11, va="center")
    figure.canvas.draw()
    # Without the opacity of each pixel, which is 1.
    Image.fromarray(numpy.asarray(figure.canvas.buffer_rgba())).convert("RGB").save(sheet, optimize=True)


MAP_PART = (0.14, 0.115, 0.875, 0.89)  # left, upper, right and lower edge of a square map in a picture of 8 : 7


def shrunk(path, width, part):
    from PIL import Image

    with Image.open(path) as whole:
        edges = [round(edge * size) for edge, size in zip(MAP_PART, whole.size * 2)]
        picture = whole.convert("RGB").crop(edges) if part == "map" else whole.convert("RGB")
    return picture.resize((width, round(picture.height * width / picture.width)), Image.LANCZOS)


def write_pairs(text, sheet, columns, width, part, pairs):
    """Each pair beside each other below its label. At most 128 colours, so that many maps fit a small file."""
    import matplotlib.font_manager
    from PIL import Image, ImageDraw, ImageFont

    font = ImageFont.truetype(matplotlib.font_manager.findfont("DejaVu Sans"), 12)
    height = shrunk(pairs[0][1], width - 1, part).height
    gap, line = 8, 18
    rows = -(-len(pairs) // columns)
    size = (columns * (2 * width + gap) + gap, CAPTION + rows * (height + line + gap))
    picture = Image.new("RGB", size, "black")
    draw = ImageDraw.Draw(picture)
    draw.text((gap, CAPTION / 2), text, fill="white", font=font, anchor="lm")
    for number, (label, *maps) in enumerate(pairs):
        left = gap + number % columns * (2 * width + gap)
        top = CAPTION + number // columns * (height + line + gap)
        draw.text((left, top + line / 2), label, fill="white", font=font, anchor="lm")
        for place, path in enumerate(maps):
            picture.paste(shrunk(path, width - 1, part), (left + place * width, top + line))
    picture.quantize(128, dither=Image.Dither.NONE).save(sheet, optimize=True)


def lines_of(path):
    with open(path, encoding="utf-8") as file:
        return [[html.escape(part) for part in line.rstrip("\n").split("\t", 1)] for line in file]


def write_index(sheets, left_out, page):
    parts = ["<!DOCTYPE html><meta charset='utf-8'><title>Contact sheets</title>"]
    parts.append("<style>body{font-family:sans-serif}img{width:100%;max-width:1500px}</style>")
    parts += [f"<p>{text}<br><a href='{name}'><img loading='lazy' src='{name}'></a></p>" for name, text in sheets]
    if left_out:
        parts.append("<h2>Could not be drawn</h2><ul>")
        parts += [f"<li>{name}: {reason}</li>" for name, reason in left_out]
        parts.append("</ul>")
    with open(page, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")


def main(task, *arguments):
    if task == "middle":
        volume = described(arguments[0])
        reach = "90km" if volume["vcp"] in TERMINAL_PATTERNS else "230km"
        print(f"{middle(volume):%Y-%m-%dT%H:%M:%S} {reach}")
    elif task == "sheet":
        text = caption(described(arguments[0]), arguments[1])
        write_sheet(text, arguments[2], arguments[3:])
        print(text)
    elif task == "pictures":
        write_sheet(arguments[0], arguments[1], arguments[2:])
    elif task == "pairs":
        text, sheet, columns, width, part, *rest = arguments
        write_pairs(text, sheet, int(columns), int(width), part, list(zip(*[iter(rest)] * 3)))
    else:
        write_index(lines_of(arguments[0]), lines_of(arguments[1]), arguments[2])


main(*sys.argv[1:])

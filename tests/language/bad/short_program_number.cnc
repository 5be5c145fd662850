(2: Programmnummer P falsch, richtig: P0000..P9999. P und vier Ziffern angeben.)
P12 N001 G17

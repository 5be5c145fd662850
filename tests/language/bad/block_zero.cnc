(3: P0001: Satznummer N 000 geht nicht, richtig: N001..N999. Andere Nummer wählen.)
P0001
N000 G17

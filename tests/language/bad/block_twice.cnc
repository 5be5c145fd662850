(4: P0001 N001: Satznummer N 2× geht nicht. Andere Nummer wählen.)
P0001
N001 G17
N001 G18
